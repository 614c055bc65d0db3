// The review of matches of a team: what cost goals, and what would have been better.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/text/json.h"
#include "review/chances.h"
#include "review/losses.h"
#include "review/reference.h"
#include "review/verdict.h"

namespace cls::review {

/// A match of the team.
struct ReviewedMatch {
  std::string file;    ///< of the game log
  std::string folder;  ///< what `cls watch` shows
  soccer::Side side = soccer::Side::kLeft;
  std::string opponent;
  int goals = 0;
  int goals_against = 0;
  Chances chances;
  std::vector<Loss> losses;  ///< of each decision with the ball in live play
};

/// How the team differs from another one.
struct Reference {
  std::string team;
  std::size_t matches = 0;
  std::vector<Difference> differences;  ///< farthest first
};

struct Review {
  std::string team;
  std::vector<ReviewedMatch> matches;
  std::optional<Reference> reference;
  std::vector<Verdict> decisions;    ///< by cost, highest first
  std::vector<std::string> skipped;  ///< decisions that could not be played again, and why
  std::string continued_by;          ///< who plays on after the decision: "planner"
  PlayoutTerms terms;
  bool interrupted = false;
};

inline constexpr const char* kReviewSchema = "cls.review/1";

/// The document of this schema.
base::Json to_json(const Review& review);

/// `most`: rows of each table.
std::string to_text(const Review& review, std::size_t most);

}  // namespace cls::review
