// Schedule of the steps of a match in real time, and their lateness.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace cls::simulator {

/// Schedules steps at a fixed interval. A step that is up to a millisecond late does not delay
/// later steps. A later step delays all later steps, so that clients always have a whole cycle
/// (docs/spec/server-protocol.md 8.1).
class StepTimer {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::nanoseconds;

  /// `first`: due time of the first step.
  StepTimer(Duration step, Time first) : step_(step), due_(first) {}

  Time due() const { return due_; }

  /// Records that the due step was made at `now`.
  void record_step(Time now);

  /// Lateness of the steps so far, in milliseconds.
  struct Lateness {
    std::int64_t steps = 0;
    double mean_ms = 0.0;
    double p99_ms = 0.0;  ///< rounded up to 0.1 ms
    double worst_ms = 0.0;
    std::int64_t delayed = 0;  ///< steps that delayed later steps
  };
  Lateness lateness() const;

 private:
  static constexpr std::size_t kBuckets = 1000;  ///< of 0.1 ms; the last bucket has no upper bound

  Duration step_;
  Time due_;
  std::array<std::int64_t, kBuckets> histogram_{};
  std::int64_t steps_ = 0;
  std::int64_t delayed_ = 0;
  Duration sum_{0};
  Duration worst_{0};
};

}  // namespace cls::simulator
