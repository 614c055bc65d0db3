// Results as one JSON document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

/// Schema "cls.results/1" (docs/formats/results.md), indented, with a line feed at the end. Bytes
/// in names that are no UTF-8 become U+FFFD.
std::string results_json(const std::vector<MatchSummary>& matches);

/// "left", "right", "draw"; empty for kNone, which is null in JSON.
std::string_view winner_word(Winner winner);

}  // namespace cls::analysis
