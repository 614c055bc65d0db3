// The limits that end a match from outside: signals, time limit, start limit, stall limit.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/end_reason.h"

namespace cls::orchestration::match {

/// Looked at while the match's thread waits for the sides.
class DeadlineWatch {
 public:
  using Clock = std::chrono::steady_clock;

  DeadlineWatch(const MatchOptions& options, const std::atomic<int>& stop_signal)
      : options_(options), stop_signal_(stop_signal) {}

  /// A new cycle has begun: the stall limit counts from here; before the first one the start
  /// limit does, from the creation of the watch.
  void cycle_begins() { last_cycle_ = Clock::now(); }

  /// Why the match has to end now; nothing while it may go on.
  std::optional<EndReason> exceeded() const;

  /// True when a signal to end the match is there or comes within `time`: waits for it.
  bool interrupted_within(std::chrono::milliseconds time) const;

  int signal() const { return stop_signal_.load(); }
  double seconds_since_start() const;

 private:
  const MatchOptions& options_;
  const std::atomic<int>& stop_signal_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> last_cycle_;
};

}  // namespace cls::orchestration::match
