// Formats result tables.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

enum class ResultsFormat : unsigned char { kTable, kJson, kCsv, kMarkdown };

/// Formats all matches and, for several matches (in JSON always), the table of teams. JSON has the
/// schema "cls.results/1" (docs/formats/results.md). CSV has one row per match, with lists as "169
/// l 11; 1313 r 10".
/// Lines of a kTable have `width` characters at most, for which lists of goals are cut.
std::string format_results(const std::vector<MatchSummary>& matches, ResultsFormat format,
                           std::size_t width = 80);

/// The document "cls.results/1", indented, with a line feed at the end. Bytes in names that are not
/// UTF-8 become U+FFFD.
std::string results_json(const std::vector<MatchSummary>& matches);

/// "0:0 (2:4 pen.)"; the shoot-out only if there was one.
std::string score_text(const MatchSummary& match);

}  // namespace cls::analysis
