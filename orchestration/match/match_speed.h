// The speed of a match while it is played: who limits it, how long it will take.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/result/speed.h"
#include "orchestration/match/sides/match_side.h"

namespace cls::orchestration::match {

/// Used by the match's thread only. `options` and `sides` must outlive this.
class MatchSpeed {
 public:
  using Duration = std::chrono::nanoseconds;
  using Sides = std::vector<std::unique_ptr<MatchSide>>;

  MatchSpeed(const MatchOptions& options, const Sides& sides, bool lockstep)
      : options_(options), sides_(sides), lockstep_(lockstep) {}

  /// Of one cycle in lockstep: waiting for the clock of --speed, and the server's step.
  void add_step(Duration clock, Duration server);
  /// Of one cycle in lockstep, where the sides have no work now: the decisions, which took `wall`.
  void add_turns(Duration wall);

  /// Of a slow match, once: how long it will take, and who limits that. `steps` were made in
  /// `played`, `now` is where the match is.
  std::optional<std::string> estimate(const MatchProgress& now, std::int64_t steps,
                                      Duration played);

  /// After wait_gone() of all sides: nothing if no cycle was played. `result` has the teams.
  std::optional<SpeedResult> result(Duration played, const MatchResult& result) const;

 private:
  bool is_paced() const;
  SpeedResult shares(Duration played) const;

  const MatchOptions& options_;
  const Sides& sides_;
  bool lockstep_;
  SpeedMeter meter_;                   ///< in lockstep
  std::array<TurnTimes, 3> measured_;  ///< of the sides, up to the last turn
  bool estimated_ = false;
};

}  // namespace cls::orchestration::match
