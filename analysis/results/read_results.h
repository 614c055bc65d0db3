// Reads the results of many logs in parallel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "gamelog/files/log_files.h"
#include "gamelog/record/parse_errors.h"

namespace cls::analysis {

/// The logs of a match, and what is recorded outside of them.
struct MatchInput {
  gamelog::MatchLogs logs;
  std::optional<RecordedEnd> end;
  std::string date = {};  ///< YYYYMMDDhhmm, for logs that hold no true one
};

/// Result of reading the logs of one match.
struct ReadResult {
  MatchSummary summary;
  bool usable = false;          ///< `summary` is valid
  std::string unreadable;       ///< why the log could not be opened; empty if it was opened
  gamelog::ParseErrors errors;  ///< of the log `error_file`
  std::string error_file;
};

/// One entry per match, in the same order, read on `jobs` threads. The text log is read only if the
/// game log lacks something: a level shoot-out, cards before version 4. `on_done` is called after
/// each match with the number of finished matches, on any thread.
std::vector<ReadResult> read_results(const std::vector<MatchInput>& matches, std::size_t jobs,
                                     const std::function<void(std::size_t)>& on_done = nullptr);

}  // namespace cls::analysis
