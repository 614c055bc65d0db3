// The result of a match as a person reads it.
#pragma once

#include <string>

#include "orchestration/match/result/match_result.h"

namespace cls::cli {

/// The table that `cls match` prints: score, goals, figures of both sides, where the files are.
/// With `colour`, the score line is emphasised.
std::string match_report(const orchestration::match::MatchResult& result, bool colour);

}  // namespace cls::cli
