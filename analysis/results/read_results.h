// Results of many logs, read side by side.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "gamelog/files/log_files.h"
#include "gamelog/record/damage.h"

namespace cls::analysis {

/// What became of one match's logs.
struct ReadResult {
  MatchSummary summary;
  bool usable = false;         ///< there is something in `summary`
  std::string unreadable;      ///< why a log could not be opened; empty: it could
  gamelog::DamageList damage;  ///< of the log that `damaged_file` names
  std::string damaged_file;
};

/// One entry a match, in the same order. The text log is only read where the game log leaves
/// something open: a level shoot-out, cards before version 4. `on_done`, if any, hears after each
/// match how many are done, on any thread.
std::vector<ReadResult> read_results(const std::vector<gamelog::MatchLogs>& matches,
                                     std::size_t jobs,
                                     const std::function<void(std::size_t)>& on_done = nullptr);

}  // namespace cls::analysis
