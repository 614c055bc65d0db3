// Where the matches of a tournament are played.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// A match to be played now; `number` is the attempt, from 1.
struct Assignment {
  Fixture fixture;
  int number = 1;
};

/// An assignment that has come to its end.
struct Finished {
  int index = 0;
  std::optional<Outcome> outcome;  ///< nothing: interrupted, it was not played to an end
};

/// Plays matches somewhere: processes of this machine (local_executor), a cluster, or, in tests,
/// nowhere at all. All calls come from one thread.
class MatchExecutor {
 public:
  virtual ~MatchExecutor() = default;

  /// How many more matches it takes now.
  virtual int room() const = 0;

  /// Begins to play. An error when nothing can be played.
  virtual base::Result<void> start(std::span<const Assignment> assignments) = 0;

  /// Waits for ends, not longer than `limit`; may return none. An error when something is wrong
  /// that no other match would escape.
  virtual base::Result<std::vector<Finished>> wait(std::chrono::milliseconds limit) = 0;

  /// Asks all matches under way to end in order; wait() then returns them.
  virtual void interrupt() = 0;

  /// Matches under way.
  virtual int running() const = 0;

  /// Asks for those matches back that were handed over and that nobody plays yet; wait() then
  /// returns them without an outcome. Matches that are being played go on.
  virtual void withdraw() {}

  /// Called once, before anything else: numbers of those of `matches` (all, by number) that an
  /// earlier run handed over and that may still be played. They are under way now.
  virtual base::Result<std::vector<int>> take_over(std::span<const ScheduledMatch> /*matches*/) {
    return std::vector<int>();
  }

  /// What is worth telling since the last call, such as a change of concurrency.
  virtual std::vector<std::string> take_notes() { return {}; }
};

/// Processes of this machine: config.concurrency at a time, or as many as processors when that is
/// 0. Automatic concurrency goes down by one when a match missed cycles, since then the machine
/// was too busy; without lockstep it begins with one match for four processors and goes up by one
/// after as many matches without a miss as run at once.
base::Result<std::unique_ptr<MatchExecutor>> local_executor(const TournamentConfig& config,
                                                            const std::filesystem::path& folder,
                                                            const std::filesystem::path& program);

/// A Slurm cluster that sees `folder` and `program` under the same names: job arrays of `cls
/// tournament work`, whose results are collected from the folder. See slurm_executor.cpp.
base::Result<std::unique_ptr<MatchExecutor>> slurm_executor(const TournamentConfig& config,
                                                            const std::filesystem::path& folder,
                                                            const std::filesystem::path& program);

/// The one that config.executor names.
base::Result<std::unique_ptr<MatchExecutor>> make_executor(const TournamentConfig& config,
                                                           const std::filesystem::path& folder,
                                                           const std::filesystem::path& program);

}  // namespace cls::orchestration::tournament
