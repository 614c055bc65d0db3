// Schedules the steps of a match in real time.
#include "simulator/server/step_timer.h"

#include <algorithm>

namespace cls::simulator {
namespace {

constexpr std::chrono::milliseconds kMaxLateness{1};
constexpr std::chrono::microseconds kBucketWidth{100};

double milliseconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

void StepTimer::record_step(Time now) {
  const Duration late = std::max(Duration(0), Duration(now - due_));
  const auto bucket =
      std::min<std::size_t>(static_cast<std::size_t>(late / kBucketWidth), kBuckets - 1);
  ++histogram_[bucket];
  ++steps_;
  sum_ += late;
  worst_ = std::max(worst_, late);
  if (late > kMaxLateness) {
    ++delayed_;
    due_ = now;
  }
  due_ += step_;
}

StepTimer::Lateness StepTimer::lateness() const {
  Lateness result;
  result.steps = steps_;
  if (steps_ == 0) return result;
  result.mean_ms = milliseconds(sum_) / static_cast<double>(steps_);
  result.worst_ms = milliseconds(worst_);
  result.delayed = delayed_;
  std::int64_t counted = 0;
  std::size_t bucket = 0;
  while (bucket + 1 < kBuckets && (counted += histogram_[bucket]) * 100 < steps_ * 99) ++bucket;
  result.p99_ms =
      std::min(milliseconds(kBucketWidth) * static_cast<double>(bucket + 1), result.worst_ms);
  return result;
}

}  // namespace cls::simulator
