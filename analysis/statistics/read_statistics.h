// Reads statistics of many logs in parallel.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/results/read_results.h"
#include "gamelog/record/parse_errors.h"

namespace cls::analysis {

enum class StatisticsFormat : unsigned char {
  kText,
  kJson,
  kCsv,
  kCsvPlayers,
  kCsvEvents,
  kSpadl,
};

/// Errors of one log.
struct LogProblem {
  std::string file;
  std::string unreadable;  ///< why the log could not be opened; empty if it was opened
  gamelog::ParseErrors errors;
};

struct StatisticsOutput {
  std::string text;  ///< all matches in the requested format; may be empty
  std::vector<LogProblem> problems;
};

/// Statistics require the game log; a text log alone is a problem. JSON has the schema
/// "cls.stats/1". `on_done` as for read_results(), `width` as for statistics_text().
StatisticsOutput read_statistics(const std::vector<MatchInput>& matches, StatisticsFormat format,
                                 bool events, std::size_t jobs,
                                 const std::function<void(std::size_t)>& on_done = nullptr,
                                 std::size_t width = 80);

}  // namespace cls::analysis
