// One attempt at a match: the `cls match` process that plays it and what is made of its end.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/process/process_host.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// The binary that runs now, for starting more of it.
std::filesystem::path own_program();

/// `cls match` as it plays the fixture; `folder` is the match folder. The same line of shell plays
/// the same match again.
process::CommandPlan match_plan(const TournamentConfig& config, const Fixture& fixture,
                                const std::filesystem::path& program,
                                const std::filesystem::path& folder);

/// Where and with what an attempt is played.
struct AttemptPlace {
  std::filesystem::path tournament;  ///< the tournament's folder
  std::filesystem::path folder;      ///< match folder below it; empty: as match_folder names it
  std::filesystem::path program;     ///< `cls`
  std::vector<int> cpus;             ///< processors it may run on; empty: all
};

/// An attempt under way.
class MatchAttempt {
 public:
  /// Starts `cls match`. The error says why it cannot be started.
  static base::Result<MatchAttempt> start(process::ProcessHost& host,
                                          const TournamentConfig& config, const Fixture& fixture,
                                          int attempt, AttemptPlace place);

  const Fixture& fixture() const { return fixture_; }
  int number() const { return number_; }
  bool ended() const { return child_->status().gone; }

  /// Ends the process when it is well beyond its own time limit and shows no reaction.
  void enforce_limit();
  /// Asks the match to end in order; it then has no outcome.
  void interrupt();

  /// After the end: the outcome; nothing when it was interrupted. An error when the process left
  /// no result and did not crash either: then no match of this tournament can be played.
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
};

/// The outcome of an attempt that ended while nobody looked: from the result.json of its folder.
/// Nothing when that is missing, of another seed or tells of an interruption.
std::optional<Outcome> left_behind(const TournamentConfig& config, const Fixture& fixture,
                                   int attempt, const std::filesystem::path& tournament);

/// Removes what `keep_logs` does not want of all attempts at a match, and attempts without result.
/// Call it when the outcome is committed.
void clean_up(const TournamentConfig& config, const Fixture& fixture, const Outcome& outcome,
              const std::filesystem::path& tournament);

/// True when the folder of a match with this outcome is to be kept.
bool keeps_folder(const TournamentConfig& config, const Outcome& outcome);

}  // namespace cls::orchestration::tournament
