// When the steps of a match in real time are due, and how punctual they were.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

namespace cls::simulator {

/// Steps at a fixed distance. A step that is up to a millisecond late does not delay the others;
/// one that is later does: lost time is not made up, so that clients always have their whole cycle
/// (protocol 8.1).
class StepClock {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::nanoseconds;

  /// `first`: when the first step is due.
  StepClock(Duration step, Time first) : step_(step), due_(first) {}

  Time due() const { return due_; }

  /// The step that is due is made now.
  void made(Time now);

  /// Lateness of the steps so far, in milliseconds.
  struct Lateness {
    std::int64_t steps = 0;
    double mean_ms = 0.0;
    double p99_ms = 0.0;  ///< rounded up to 0.1 ms
    double worst_ms = 0.0;
    std::int64_t delayed = 0;  ///< steps that moved all later ones
  };
  Lateness lateness() const;

 private:
  static constexpr std::size_t kBuckets = 1000;  ///< of 0.1 ms; the last one holds the rest

  Duration step_;
  Time due_;
  std::array<std::int64_t, kBuckets> histogram_{};
  std::int64_t steps_ = 0;
  std::int64_t delayed_ = 0;
  Duration sum_{0};
  Duration worst_{0};
};

}  // namespace cls::simulator
