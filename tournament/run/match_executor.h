// Executors that play the matches of a tournament: on this host, on others, or on a Slurm cluster.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// A match to play now; `number` is the attempt, from 1.
struct Assignment {
  Fixture fixture;
  int number = 1;
};

/// An assignment that ended.
struct FinishedMatch {
  int index = 0;
  std::optional<Outcome> outcome;  ///< nothing: interrupted or lost
};

/// Plays matches, or, in tests, makes up their results. All calls come from one thread.
class MatchExecutor {
 public:
  virtual ~MatchExecutor() = default;

  /// Number of further matches that start() accepts now.
  virtual int free_slots() const = 0;

  /// Starts matches. An error when no match can be played.
  virtual base::Result<void> start(std::span<const Assignment> assignments) = 0;

  /// Waits at most `limit` for matches to end; may return none. An error when the cause would stop
  /// every other match too.
  virtual base::Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds limit) = 0;

  /// Asks all running matches to shut down cleanly; wait() then returns them.
  virtual void interrupt() = 0;

  /// Number of assigned matches that have not ended.
  virtual int running() const = 0;

  /// Cancels assigned matches that have not started; wait() then returns them without an outcome.
  /// Running matches continue.
  virtual void withdraw() {}

  /// While held, matches that have not started wait.
  virtual void hold(bool /*held*/) {}

  /// Called once, before anything else. Returns the numbers of those `matches` (all, by number)
  /// that an earlier run assigned and that may still be running; they count as running.
  virtual base::Result<std::vector<int>> take_over(std::span<const ScheduledMatch> /*matches*/) {
    return std::vector<int>();
  }

  /// Messages for the user since the last call, such as a change of concurrency.
  virtual std::vector<std::string> take_notes() { return {}; }
};

/// Processes on this host: config.execution.concurrency in parallel, or one per core when that is
/// 0. Automatic concurrency decreases by one when a match missed cycles, because the host was too
/// busy. Without lockstep it starts with one match per four cores and increases by one after as
/// many matches without a miss as run in parallel.
base::Result<std::unique_ptr<MatchExecutor>> local_executor(const TournamentConfig& config,
                                                            const std::filesystem::path& folder,
                                                            const std::filesystem::path& program);

/// A Slurm cluster that sees `folder` and `program` under the same names: job arrays of `cls
/// tournament work`, whose result files are collected from the folder. See slurm_executor.cpp.
base::Result<std::unique_ptr<MatchExecutor>> slurm_executor(const TournamentConfig& config,
                                                            const std::filesystem::path& folder,
                                                            const std::filesystem::path& program);

/// Hosts that share nothing with this one and are reached by config.execution.remote_shell: teams
/// and `program` are copied there, results and logs back. See hosts_executor.cpp.
base::Result<std::unique_ptr<MatchExecutor>> hosts_executor(const TournamentConfig& config,
                                                            const std::filesystem::path& folder,
                                                            const std::filesystem::path& program);

/// Plays nothing: takes results from a file (ResultsFile). A match that the file lacks is an error.
base::Result<std::unique_ptr<MatchExecutor>> results_executor(const TournamentConfig& config,
                                                              const std::filesystem::path& file);

/// The executor that config.execution.executor names.
base::Result<std::unique_ptr<MatchExecutor>> make_executor(const TournamentConfig& config,
                                                           const std::filesystem::path& folder,
                                                           const std::filesystem::path& program);

}  // namespace cls::tournament
