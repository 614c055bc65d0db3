// One attempt at a match: the `cls match` process that plays it, and its outcome.
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
#include "process/process_host.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// The `cls match` command of the fixture; `folder` is the match folder. It reproduces the match.
process::CommandPlan match_plan(const TournamentConfig& config, const Fixture& fixture,
                                const std::filesystem::path& program,
                                const std::filesystem::path& folder);

/// Where and how an attempt is played.
struct AttemptOptions {
  std::filesystem::path tournament;  ///< the tournament's folder
  std::filesystem::path folder;      ///< match folder below it; empty: match_folder(), or one below
                                     ///< unfinished/ where another process has that
  std::filesystem::path program;     ///< `cls`
  std::vector<int> cpus;             ///< CPUs it may run on; empty: all
};

/// A running attempt.
class MatchAttempt {
 public:
  /// Starts `cls match`.
  static base::Result<MatchAttempt> start(process::ProcessHost& host,
                                          const TournamentConfig& config, const Fixture& fixture,
                                          int attempt, AttemptOptions options);

  const Fixture& fixture() const { return fixture_; }
  int number() const { return number_; }
  /// No process of it is left.
  bool exited() const { return child_->status().gone; }

  /// Kills the match when it runs well beyond its own time limit, and what outlives it: without its
  /// guard no other process does. Call again and again until exited().
  void end_overdue();
  /// Asks the match to shut down cleanly; it then has no outcome.
  void interrupt();

  /// After the exit: the outcome; nothing when it was interrupted. An error when the process wrote
  /// no result and did not crash: then no match of this tournament can be played.
  base::Result<std::optional<Outcome>> outcome() const;

 private:
  MatchAttempt() = default;

  std::shared_ptr<process::Child> child_;
  Fixture fixture_;
  int number_ = 1;
  std::filesystem::path tournament_;
  std::filesystem::path folder_;  // below tournament_
  std::chrono::steady_clock::time_point begin_;
  std::optional<double> limit_s_;
  std::string started_;
  bool interrupted_ = false;
  bool timed_out_ = false;
  bool ended_rest_ = false;
};

/// True when `folder` holds the result of a match, valid or not, but not an interrupted one.
bool holds_result(const std::filesystem::path& folder);

/// True when it is that of this match: a replay has another seed than what it replaces.
bool was_played(const std::filesystem::path& folder, const Fixture& fixture);

/// True when `folder` holds what an interrupted match has written at its end.
bool was_interrupted(const std::filesystem::path& folder, const Fixture& fixture);

/// The outcome of an attempt that another process played, from the result.json of its match folder.
/// Nothing when that is missing or the match is invalid.
std::optional<Outcome> recover_result(const TournamentConfig& config, const Fixture& fixture,
                                      int attempt, const std::filesystem::path& tournament);

/// The same, valid or not, with the times of the files.
std::optional<Outcome> read_again(const TournamentConfig& config, const Fixture& fixture,
                                  int attempt, const std::filesystem::path& tournament);

/// Removes the folders of all attempts at a match that `keep_logs` does not keep, and of attempts
/// without a result, below matches/, and that of the last attempt if another one counts. Call it
/// when the outcome is committed.
void clean_up(const TournamentConfig& config, const Fixture& fixture, const Outcome& outcome,
              const std::filesystem::path& tournament);

/// Removes what killed `work` processes have left below unfinished/ of `matches` with an outcome,
/// and the temporary files of all killed processes.
void clean_up_unfinished(std::span<const ScheduledMatch> matches,
                         const std::filesystem::path& tournament);

/// True when `keep_logs` keeps the folder of a match with this outcome.
bool keeps_folder(const TournamentConfig& config, const Outcome& outcome);

}  // namespace cls::tournament
