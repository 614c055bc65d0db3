// Runs a tournament to its end: a new one, or one that an earlier run left incomplete.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text/enum_names.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"
#include "tournament/run/match_executor.h"

namespace cls::tournament {

/// Progress of a tournament.
struct RunProgress {
  int total = 0;    ///< scheduled so far
  int done = 0;     ///< with a final outcome
  int invalid = 0;  ///< of those done
  int running = 0;
  int done_in_this_run = 0;
  double seconds = 0.0;  ///< of this run
};

/// Observes a tournament. Called from the thread that runs it.
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
  kDecided,        ///< RunOptions::decided returned true
  kStopRequested,  ///< `cls tournament stop`
  kInterrupted,    ///< by a signal
  kFault,          ///< on_crash = "stop" and a match was invalid
};

/// Its name in events.jsonl.
constexpr std::string_view name(RunEnd end) {
  return base::enum_names<RunEnd>("complete", "decided", "stopped", "interrupted", "fault")
      .name(end);
}

struct RunOptions {
  std::filesystem::path folder;
  TournamentConfig config;
  /// Further matches when all so far are done; empty: next_fixtures(). Must be a pure function.
  std::function<std::vector<Fixture>(std::span<const ScheduledMatch>)> next;
  /// Later matches of the folder are neither played nor counted; none: no limit.
  std::optional<int> last_match;
  /// Called after every outcome; true stops the run and interrupts running matches.
  std::function<bool(std::span<const ScheduledMatch>)> decided;
};

struct RunSummary {
  RunEnd end = RunEnd::kComplete;
  int signal = 0;           ///< for kInterrupted
  std::string message;      ///< for kFault: the match and what went wrong
  std::string write_error;  ///< why events.jsonl lacks events; empty: it has all
  RunProgress progress;
  std::vector<ScheduledMatch> matches;
};

/// Creates the executor once configuration and folder are valid.
using MakeExecutor =
    std::function<base::Result<std::unique_ptr<MatchExecutor>>(const TournamentConfig&)>;

/// Plays all matches that have no outcome. `options.folder` must hold the plan (prepare_folder),
/// and the caller must hold its lock. First recovers the outcomes of matches that ended while no
/// run was running, and of `work`. Commits each outcome before using it. An error when the cause is
/// not one match: a file cannot be written, a match cannot be started.
base::Result<RunSummary> run_tournament(const RunOptions& options, const MakeExecutor& make,
                                        TournamentObserver& observer,
                                        const std::atomic<int>& stop_signal);

}  // namespace cls::tournament
