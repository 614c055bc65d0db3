// Scheduled matches and their outcomes as plain data.
#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/index.h"
#include "league/matches/decision.h"
#include "soccer/end_reason.h"
#include "soccer/side.h"

namespace cls::league {

/// One match of the schedule. Teams are indices into Competition::teams.
struct Fixture {
  int index = 0;      ///< match number, from 1
  int round = 1;      ///< from 1
  std::string stage;  ///< "", "group A", "semi-final 2", "final"
  int pairing = 0;    ///< matches of one pairing have the same teams and seed, sides swapped
  int left = 0;
  int right = 0;
  std::uint64_t seed = 0;
  bool decides = false;  ///< a draw leads to extra time and penalties

  bool operator==(const Fixture&) const = default;
};

/// Decisions and latencies of one side's agents. Latencies are those of a Playmaker's replies.
struct SideStats {
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  double rpc_p50_us = 0.0;  ///< of the median player
  double rpc_p95_us = 0.0;  ///< this and the next two: of the slowest player
  double rpc_p99_us = 0.0;
  double rpc_max_us = 0.0;
  double cpu_seconds = 0.0;
};

/// How a fixture ended: the part of a MatchResult that a tournament needs, and how it was run.
struct Outcome {
  soccer::EndReason end_reason = soccer::EndReason::kFinished;
  bool forfeit = false;   ///< the score is 0:3 or 3:0 by rule, or another one by decision
  bool annulled = false;  ///< counts for nothing, by decision
  int left_score = 0;
  int right_score = 0;
  std::optional<int> left_penalties;
  std::optional<int> right_penalties;
  std::optional<double> value;        ///< of the situations of a book: goals a match, left team
  std::optional<soccer::Side> fault;  ///< side of the Playmaker that made it invalid
  std::string message;                ///< what went wrong
  std::vector<std::string> warnings;  ///< of the match, in its own words

  int attempts = 1;  ///< times it was started
  int cycles = 0;
  double wall_seconds = 0.0;  ///< as `cls match` reports it
  double run_seconds = 0.0;   ///< from start to exit of the process
  double cycles_per_second = 0.0;
  bool deterministic = true;
  std::string mode;
  std::string started;  ///< UTC, ISO 8601
  std::string ended;
  std::string host;
  double load = 0.0;    ///< one-minute load average of the host at the end
  std::string version;  ///< of cls
  std::string server;   ///< kind and version of the soccer server
  std::string folder;   ///< match folder inside the tournament's; empty: removed
  SideStats left;
  SideStats right;

  /// Played to the end.
  bool finished() const { return end_reason == soccer::EndReason::kFinished; }
  /// Counts for tables: played to the end, or forfeited.
  bool counts() const { return !annulled && (forfeit || finished()); }
  /// Counts for ratings: played to the end.
  bool played() const { return !annulled && !forfeit && finished(); }
  /// Neither counts nor was annulled by decision.
  bool invalid() const { return !annulled && !counts(); }
};

/// A fixture, and its outcome once it has one.
struct ScheduledMatch {
  Fixture fixture;
  std::optional<Outcome> outcome;
  int attempts = 0;                          ///< started so far
  int settled = 0;                           ///< the latest attempt whose outcome was recorded
  std::optional<MatchDecision> decision;     ///< the one that counts, see apply_decisions()
  std::vector<MatchDecision> history;        ///< all decisions on the match, in their order
  std::optional<std::uint64_t> replay_seed;  ///< of the latest replay
};

/// A match that was not played yet.
inline ScheduledMatch planned(Fixture fixture) {
  ScheduledMatch match;
  match.fixture = std::move(fixture);
  return match;
}

bool all_have_outcomes(std::span<const ScheduledMatch> matches);

/// The match of an attempt of an earlier run that may still bring its result; null: there is none
/// of this number, or a result or a later attempt is known.
inline const ScheduledMatch* awaited_match(std::span<const ScheduledMatch> matches, int index,
                                           int attempt) {
  if (index < 1 || index > std::ssize(matches)) return nullptr;
  const ScheduledMatch& match = matches[base::index(index) - 1];
  const bool late = match.outcome || attempt <= match.settled || attempt < match.attempts;
  return late ? nullptr : &match;
}

/// The seed of a pairing, from 1 to 2^31 - 1 so that every soccer server accepts it. Pairings of a
/// tournament have distinct seeds.
std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing);

/// True when a shoot-out was played.
inline bool had_shoot_out(const Outcome& outcome) {
  return outcome.left_penalties.has_value() && outcome.right_penalties.has_value();
}

/// "2:1", "2:2 (4:3 pen)", "annulled" or the end reason of a match that does not count; swapped: as
/// the right side sees it.
std::string result_text(const Outcome& outcome, bool swapped = false);

/// +1 when the left side won, -1 when the right side did, 0 for a draw. Penalties decide a match
/// with equal scores. Only for outcomes that count.
inline int winner_sign(const Outcome& outcome) {
  const std::pair left(outcome.left_score, outcome.left_penalties.value_or(0));
  const std::pair right(outcome.right_score, outcome.right_penalties.value_or(0));
  return left == right ? 0 : left > right ? 1 : -1;
}

}  // namespace cls::league
