// Notices that this process stood still: Ctrl-Z or SIGSTOP and SIGCONT, or a host that did not run
// it.
#pragma once

#include <chrono>
#include <utility>

namespace cls::base {

/// For a loop that comes around every moment. Time in which the loop did not run is nobody's delay.
class StandstillWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// The time since the last call, or since the construction, if it was a standstill; else zero.
  Clock::duration check(Clock::time_point now = Clock::now()) {
    const Clock::duration gap = now - std::exchange(last_, now);
    return gap > kLongestRound ? gap : Clock::duration::zero();
  }

 private:
  static constexpr std::chrono::seconds kLongestRound{3};

  Clock::time_point last_ = Clock::now();
};

}  // namespace cls::base
