// Result table of `cls match`.
#pragma once

#include <cstddef>
#include <string>

#include "match/result/match_result.h"

namespace cls::cli {

/// The table that `cls match` prints: score, goals, figures of both sides, match folder.
/// With `color`, the score line is bold. Folded at `width` characters, or at 80.
std::string match_report(const match::MatchResult& result, bool color, std::size_t width);

}  // namespace cls::cli
