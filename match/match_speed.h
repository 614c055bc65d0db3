// The speed of a match while it is played: who limits it, how long it will take.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/result/speed.h"
#include "match/sides/match_side.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// Used by the match's thread only. `options` and `sides` must outlive this.
class MatchSpeed {
 public:
  using Duration = std::chrono::nanoseconds;
  /// The measured unit: each cycle by add_step() and add_turns(), or the match as a whole, in which
  /// the time without decisions belongs to the server or to its clock.
  enum class Measure { kCycles, kWholeMatch };

  MatchSpeed(const MatchOptions& options, const Sides& sides, Measure measure)
      : options_(options), sides_(sides), measure_(measure) {}

  /// Adds a cycle in lockstep: the wait for the clock of --speed, and the server's step.
  void add_step(Duration clock, Duration server);
  /// Adds the decisions of a cycle in lockstep, which took `wall`. The sides have no work now.
  void add_turns(Duration wall);

  /// The waits of the server for the programs of external teams: their turns. Where they are
  /// not known, their time is the server's.
  void set_awaited(const std::optional<soccer::PerSide<double>>& seconds) { awaited_s_ = seconds; }

  /// Says once of a slow match how long it will take, and who limits that. `steps` were made in
  /// `played`, `now` is where the match is.
  std::optional<std::string> estimate(const MatchProgress& now, std::int64_t steps,
                                      Duration played);

  /// After wait_gone() of all sides: nothing if no cycle was played. `result` has the teams.
  std::optional<SpeedResult> result(Duration played, const MatchResult& result) const;

 private:
  /// A point of the match.
  struct Moment {
    Duration played;
    std::int64_t steps;
  };

  bool is_paced() const;
  SpeedResult shares(Duration played) const;

  const MatchOptions& options_;
  const Sides& sides_;
  Measure measure_;
  std::optional<soccer::PerSide<double>> awaited_s_;
  SpeedMeter meter_;                   ///< of measured cycles
  std::array<TurnTimes, 3> measured_;  ///< of the sides, up to the last turn
  std::optional<Moment> kick_off_;     ///< the first cycle that was seen
  bool estimated_ = false;
};

}  // namespace cls::match
