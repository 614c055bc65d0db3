// The verdict of a comparison in words and as JSON.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "orchestration/tournament/report/comparison.h"

namespace cls::orchestration::tournament {

/// "better", "not better" or "undecided".
std::string_view verdict_word(const ComparisonVerdict& verdict);

/// A few lines that say who, how surely, from how much and by which test.
std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches);

/// The document cls.compare/1.
std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches);

}  // namespace cls::orchestration::tournament
