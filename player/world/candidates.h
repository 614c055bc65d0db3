// The choice among candidates by a score or by a cost.
#pragma once

#include <functional>

namespace cls::player {

/// The best candidate so far; of equal ones the first. A candidate without a number as its score is
/// never better.
template <typename T, typename Better>
struct BestOf {
  double score;  ///< of the best so far; at first the bound that a candidate must exceed
  T value{};

  /// True if this candidate is the best so far.
  bool offer(double its_score, const T& candidate) {
    if (!Better()(its_score, score)) return false;
    score = its_score;
    value = candidate;
    return true;
  }
};

template <typename T>
using Highest = BestOf<T, std::greater<>>;
template <typename T>
using Lowest = BestOf<T, std::less<>>;

}  // namespace cls::player
