// Limits compared with the clock.
#include "orchestration/match/match_limits.h"

#include <fmt/format.h>

#include <thread>

namespace cls::orchestration::match {
namespace {

constexpr std::chrono::milliseconds kSignalPollInterval{5};

double seconds_since(MatchLimits::Clock::time_point then) {
  return std::chrono::duration<double>(MatchLimits::Clock::now() - then).count();
}

}  // namespace

bool MatchLimits::interrupted_within(std::chrono::milliseconds time) const {
  const auto until = Clock::now() + time;
  while (stop_signal_.load() == 0 && Clock::now() < until) {
    std::this_thread::sleep_for(kSignalPollInterval);
  }
  return stop_signal_.load() != 0;
}

std::optional<EndReason> MatchLimits::exceeded() const {
  if (stop_signal_.load() != 0) return EndReason::kInterrupted;
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

std::string MatchLimits::describe(EndReason reason) const {
  switch (reason) {
    case EndReason::kInterrupted:
      return "interrupted";
    case EndReason::kTimedOut:
      return fmt::format("the time limit of {} s was reached", options_.time_limit_s.value_or(0));
    case EndReason::kRefused:
      return fmt::format("no answer within the start limit of {} s", options_.start_timeout_s);
    default:
      return fmt::format("no new cycle for {} s", options_.stall_after_s);
  }
}

}  // namespace cls::orchestration::match
