// Statistics of many logs, read side by side.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gamelog/files/log_files.h"
#include "gamelog/record/damage.h"

namespace cls::analysis {

enum class StatisticsFormat : unsigned char { kText, kJson, kCsv, kCsvPlayers, kCsvEvents };

/// What became of one log.
struct ReadProblem {
  std::string file;
  std::string unreadable;  ///< why it could not be opened; empty: it could
  gamelog::DamageList damage;
};

struct StatisticsOutput {
  std::string text;  ///< all matches in the wanted format; empty if there is nothing to tell
  std::vector<ReadProblem> problems;
};

/// Statistics need the game log; a text log alone is a problem. JSON is schema "cls.stats/1".
/// `on_done` as of read_results().
StatisticsOutput read_statistics(const std::vector<gamelog::MatchLogs>& matches,
                                 StatisticsFormat format, bool events, std::size_t jobs,
                                 const std::function<void(std::size_t)>& on_done = nullptr);

}  // namespace cls::analysis
