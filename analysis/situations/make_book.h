// Chooses situations from recorded matches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/situations/book.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

struct BookOptions {
  int count = 400;  ///< situations of the whole book, in equal parts of each class
  std::vector<SituationClass> classes{kDefaultClasses.begin(), kDefaultClasses.end()};
  int warm_up = 10;  ///< steps before each moment
  int spacing = 50;  ///< minimum cycles between two moments of a class
  std::uint64_t seed = 1;
};

/// Collects moments of matches, then chooses. The same matches in the same order give the same
/// book.
class BookMaker {
 public:
  explicit BookMaker(const BookOptions& options) : options_(options) {}

  /// Adds the moments of a match. Why it has none, or an empty string.
  std::string add(const gamelog::MatchRecord& record, std::string name);

  /// The book: of each class as many situations as of the others, drawn in turn from all matches.
  Book make();

  /// The moments found so far.
  std::size_t moments(SituationClass kind) const;

 private:
  BookOptions options_;
  Book book_;
  std::array<std::vector<Situation>, kSituationClasses> found_;
};

}  // namespace cls::analysis
