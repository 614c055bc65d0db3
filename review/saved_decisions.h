// Decisions that an earlier run of the same review has played.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/text/json.h"
#include "review/review.h"

namespace cls::review {

/// Read from a document `cls.review/1`.
class SavedDecisions {
 public:
  SavedDecisions() = default;

  /// The error says why `review` cannot continue the document: it is something else, or was made
  /// for another team, by another version, or under other terms.
  static base::Result<SavedDecisions> read(const base::Json& document, const Review& review);

  /// What was played of a decision in the match of the game log `file`; nothing: it was not played.
  /// Values before and after tell whether it is still the same match.
  std::optional<PlayedDecision> find(const std::string& file, const Decision& decision) const;

  /// The game logs with decisions.
  const std::set<std::string>& files() const { return files_; }

 private:
  struct Saved {
    std::string file;
    int cycle = 0;
    int unum = 0;
    double before = 0.0;
    double after = 0.0;
    std::vector<Alternative> alternatives;  ///< without plans
    Worths recorded;
    std::vector<Worths> worths;
  };

  static Saved read_decision(const base::Json& decision, const base::Json& matches);

  std::vector<Saved> decisions_;
  std::set<std::string> files_;
};

}  // namespace cls::review
