// The limits that end a match from outside: signals, time limit, start limit, stall limit.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "base/system/standstill.h"
#include "match/result/match_observer.h"
#include "match/terms/match_options.h"
#include "soccer/end_reason.h"

namespace cls::match {

using soccer::EndReason;

/// Polled by the match's thread.
class MatchLimits {
 public:
  using Clock = std::chrono::steady_clock;

  /// The start limit and the time limit count from here. Both must outlive the object.
  MatchLimits(const MatchOptions& options, const std::atomic<int>& stop_signal)
      : options_(options), stop_signal_(stop_signal) {}

  /// A new cycle has begun: the stall limit counts from here, and replaces the start limit.
  void begin_cycle() {
    last_cycle_ = Clock::now();
    stood_still_ = {};
  }

  /// Takes the place of the match: the stall limit is exceeded as well while steps are made, but
  /// the game clock is stopped for longer than any wait of the referee.
  void follow(const SourceProgress& progress);
  /// True when that is the stall.
  bool clock_stands() const;

  /// To be called every moment. The time in which this process stood still delays all limits;
  /// returns it, or zero. `now`: of the clock, or later.
  Clock::duration skip_standstill(Clock::time_point now = Clock::now());
  /// The standstills since the cycle began: calls that were open then have this much longer.
  Clock::duration stood_still() const { return stood_still_; }

  /// Why the match has to end now; nothing while it may continue.
  std::optional<EndReason> exceeded() const;
  /// The message for that reason.
  std::string describe(EndReason reason) const;

  /// True when a signal has been received or is received within `time`, which this waits for.
  bool interrupted_within(std::chrono::milliseconds time) const;

  const std::atomic<int>& signal() const { return stop_signal_; }

 private:
  const MatchOptions& options_;
  const std::atomic<int>& stop_signal_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> last_cycle_;
  SourceProgress moved_;  ///< when cycle, mode or score changed last
  std::int64_t steps_ = 0;
  Clock::time_point moved_at_ = start_;
  base::StandstillWatch watch_;
  Clock::duration stood_still_{};
};

}  // namespace cls::match
