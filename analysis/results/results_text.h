// Result tables for people and programs.
#pragma once

#include <string>
#include <vector>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

enum class ResultsFormat : unsigned char { kTable, kJson, kCsv, kMarkdown };

/// All matches and, where there are several (in JSON always), the table of teams. JSON: schema
/// "cls.results/1" (docs/formats/results.md). CSV: one row a match, lists as "169 l 11; 1313 r 10".
std::string format_results(const std::vector<MatchSummary>& matches, ResultsFormat format);

/// "0:0 (2:4 pen.)", with the shoot-out only where there was one.
std::string score_text(const MatchSummary& match);

}  // namespace cls::analysis
