// Is NEW better than BASE? The test of `cls compare` on pairs of matches.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::playground {

/// `pairs` is an array of the points that NEW got in each pair of matches, in their order: 0 to 4,
/// two for a match won, one for a draw. Pairs after the decision do not count, as in `cls compare`
/// with its usual hypotheses. An object with the members
/// - pairs, outcomes: those that count, and how many had 0 to 4 points
/// - decision: "open", "H0" (not better) or "H1" (better)
/// - score, elo, eloInterval, superiority: the strength of NEW (league::Estimate)
/// - forH1, forH0, needed: the evidence for each, and where it decides
/// - elo0, elo1: the hypotheses
/// The error names the element.
base::Result<std::string> verdict_json(std::string_view pairs);

}  // namespace cls::playground
