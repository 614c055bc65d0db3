// A scheduled match and what became of it, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "soccer/side.h"

namespace cls::orchestration::tournament {

/// One match of the schedule. Teams are indices into TournamentConfig::teams.
struct Fixture {
  int index = 0;      ///< number of the match, from 1
  int round = 1;      ///< from 1
  std::string stage;  ///< "", "group A", "semi-final 2", "final"
  int pairing = 0;    ///< matches of one pairing have the same teams and seed, sides swapped
  int left = 0;
  int right = 0;
  std::uint64_t seed = 0;
  bool decides = false;  ///< a level match goes on to extra time and penalties

  bool operator==(const Fixture&) const = default;
};

/// What one side's agents did and waited for.
struct SideFigures {
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  double rpc_p50_us = 0.0;  ///< of the middle player
  double rpc_p99_us = 0.0;  ///< of the worst player
  double cpu_seconds = 0.0;
};

/// How a fixture ended.
struct Outcome {
  std::string end_reason;  ///< as in result.json: "finished", "crashed", ...
  bool forfeit = false;    ///< the score is 0:3 or 3:0 by decision
  int left_score = 0;
  int right_score = 0;
  std::optional<int> left_penalties;
  std::optional<int> right_penalties;
  std::optional<soccer::Side> fault;  ///< whose Playmaker made it invalid
  std::string message;                ///< what went wrong

  int attempts = 1;  ///< times it was started
  int cycles = 0;
  double wall_seconds = 0.0;  ///< of `cls match`, as it says itself
  double run_seconds = 0.0;   ///< from its start to its end as a process
  double cycles_per_second = 0.0;
  bool deterministic = true;
  std::string mode;
  std::string started;  ///< UTC, ISO 8601
  std::string ended;
  std::string host;
  double load = 0.0;    ///< one-minute load of the host at its end
  std::string version;  ///< of cls
  std::string server;   ///< kind and version of the soccer server
  std::string folder;   ///< match folder inside the tournament's, empty when it was not kept
  SideFigures left;
  SideFigures right;

  /// Counts for tables: played to its end, or decided as a forfeit.
  bool counts() const { return forfeit || end_reason == "finished"; }
  /// Counts for ratings: really played to its end.
  bool played() const { return !forfeit && end_reason == "finished"; }
};

/// A fixture with its outcome once it has one.
struct ScheduledMatch {
  Fixture fixture;
  std::optional<Outcome> outcome;
  int attempts = 0;  ///< begun so far
  int settled = 0;   ///< the latest attempt whose outcome was taken into account
};

/// A match that is not played yet.
ScheduledMatch planned(Fixture fixture);

/// +1 when the left side won, -1 when the right side did, 0 for a draw. Penalties decide a level
/// match. Only for outcomes that count.
int winner_sign(const Outcome& outcome);

}  // namespace cls::orchestration::tournament
