// Slows a match down to a multiple of real time (--speed).
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

namespace cls::match {

/// Waits until `steps` steps, each of `step_ms` at `speed` 1, are due after `start`. Waits in
/// slices, so that `stopped`, which ends the wait, is noticed.
template <typename Stopped>
void keep_pace(std::chrono::steady_clock::time_point start, std::int64_t steps, double step_ms,
               double speed, const Stopped& stopped) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kSlice{50};
  const std::chrono::duration<double, std::milli> step(step_ms / speed);
  const auto due =
      start + std::chrono::duration_cast<Clock::duration>(step * static_cast<double>(steps));
  for (auto now = Clock::now(); now < due && !stopped(); now = Clock::now()) {
    std::this_thread::sleep_until(std::min(due, now + kSlice));
  }
}

}  // namespace cls::match
