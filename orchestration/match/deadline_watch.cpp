// Comparing clocks.
#include "orchestration/match/deadline_watch.h"

#include <thread>

namespace cls::orchestration::match {
namespace {

double seconds_since(DeadlineWatch::Clock::time_point then) {
  return std::chrono::duration<double>(DeadlineWatch::Clock::now() - then).count();
}

}  // namespace

double DeadlineWatch::seconds_since_start() const { return seconds_since(start_); }

bool DeadlineWatch::interrupted_within(std::chrono::milliseconds time) const {
  const auto until = Clock::now() + time;
  while (signal() == 0 && Clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return signal() != 0;
}

std::optional<EndReason> DeadlineWatch::exceeded() const {
  if (signal() != 0) return EndReason::kInterrupted;
  if (options_.time_limit_s && seconds_since(start_) > *options_.time_limit_s) {
    return EndReason::kTimedOut;
  }
  if (options_.no_deadline) return std::nullopt;
  if (!last_cycle_ && seconds_since(start_) > options_.start_timeout_s) return EndReason::kRefused;
  if (last_cycle_ && seconds_since(*last_cycle_) > options_.stall_after_s) {
    return EndReason::kStalled;
  }
  return std::nullopt;
}

}  // namespace cls::orchestration::match
