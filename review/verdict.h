// What a decision cost: estimates with intervals from playouts.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "review/estimate.h"
#include "review/playouts.h"

namespace cls::review {

/// In goals: the mean of `a` - `b` by pairs, which have had the same random numbers, over the
/// playouts from `begin` to `end` - 1.
Estimate mean_difference(const Worths& a, const Worths& b, std::size_t begin, std::size_t end);

struct Verdict {
  std::size_t match = 0;  ///< index of its match in a review
  PlayedDecision played;
  /// The alternative that the first half of the playouts prefers; none: the recorded decision.
  std::optional<std::size_t> better;
  /// What the second half says that the decision cost beside it. Without `better`: 0.
  Estimate cost;

  const Alternative* best() const { return better ? &played.alternatives[*better] : nullptr; }
};

/// One half of the playouts chooses, the other half estimates: so the estimate does not flatter
/// the alternative that had luck.
Verdict judge(PlayedDecision played, std::size_t match = 0);

/// Decisions of one kind: "dribble instead of pass".
struct VerdictGroup {
  std::string recorded;
  std::string better;
  std::size_t decisions = 0;
  Estimate cost;  ///< sum, in goals of these matches
};

/// By cost, highest first; without decisions that have no better alternative.
std::vector<VerdictGroup> group(const std::vector<Verdict>& verdicts);

}  // namespace cls::review
