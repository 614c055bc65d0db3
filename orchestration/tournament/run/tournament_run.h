// Playing a tournament: from a configuration, or from wherever an earlier run ended, to its end.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/run/match_executor.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// How far a tournament is.
struct RunProgress {
  int total = 0;    ///< scheduled so far
  int done = 0;     ///< with a final outcome
  int invalid = 0;  ///< of them, or failed
  int running = 0;
  int done_in_this_run = 0;
  double seconds = 0.0;  ///< of this run
};

/// Who wants to see it. Called from the thread that runs the tournament.
class TournamentObserver {
 public:
  virtual ~TournamentObserver() = default;
  virtual void on_progress(const RunProgress& /*progress*/) {}
  virtual void on_match(const TournamentConfig& /*config*/, const ScheduledMatch& /*match*/,
                        const RunProgress& /*progress*/) {}
  virtual void on_note(std::string_view /*line*/) {}
};

enum class RunEnd {
  kComplete,       ///< every match has its final outcome
  kDecided,        ///< RunOptions::enough said so
  kStopRequested,  ///< `cls tournament stop`
  kInterrupted,    ///< by a signal
  kFault,          ///< on_crash = "stop" and a match was invalid
};

/// The word in events.jsonl: "complete", "decided", "stopped", "interrupted", "fault".
std::string_view name(RunEnd end);

struct RunOptions {
  std::filesystem::path folder;
  TournamentConfig config;
  /// Further matches when all so far are done; empty function: those of the format
  /// (next_fixtures). Must be a pure function of its argument.
  std::function<std::vector<Fixture>(std::span<const ScheduledMatch>)> next;
  /// Asked after every outcome; true ends the run. Matches under way are ended.
  std::function<bool(std::span<const ScheduledMatch>)> enough;
};

struct RunSummary {
  RunEnd end = RunEnd::kComplete;
  int signal = 0;       ///< for kInterrupted
  std::string message;  ///< for kFault: the match and what happened
  RunProgress progress;
  std::vector<ScheduledMatch> matches;
};

/// Makes the executor once configuration and folder are known to be good.
using MakeExecutor =
    std::function<base::Result<std::unique_ptr<MatchExecutor>>(const TournamentConfig&)>;

/// Plays all that is not played yet. `options.folder` must hold the plan (prepare_folder) and the
/// caller its lock. Outcomes are committed before anything else is done with them; those of matches
/// that ended while nobody looked, and of `work`, are taken up first. An error when something is
/// wrong beyond a match: a file cannot be written, a match cannot even be started.
base::Result<RunSummary> run_tournament(const RunOptions& options, const MakeExecutor& make,
                                        TournamentObserver& observer,
                                        const std::atomic<int>& stop_signal);

}  // namespace cls::orchestration::tournament
