// Limits compared with the clock.
#include "match/match_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <tuple>

namespace cls::match {
namespace {

constexpr std::chrono::milliseconds kSignalPollInterval{5};

// More steps than the referee waits with the clock stopped, whatever the parameters say.
std::int64_t longest_wait(const soccer::ServerParams& server) {
  constexpr int kOtherWaits = 200;  // after goals, offsides and fouls
  constexpr int kMaxWait = 6000;    // ten minutes of real time
  const int wait = std::max({server.kick_off_wait, server.connect_wait, server.game_over_wait,
                             server.pen_before_setup_wait, server.pen_setup_wait,
                             server.pen_ready_wait, server.pen_taken_wait, 0});
  return std::min(wait, kMaxWait) + kOtherWaits;
}

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

void MatchLimits::follow(const SourceProgress& progress) {
  steps_ = progress.steps;
  const auto place = [](const MatchProgress& at) {
    return std::tuple(at.cycle, at.mode, at.left_score, at.right_score);
  };
  if (place(progress.match) == place(moved_.match)) return;

  moved_ = progress;
  moved_at_ = Clock::now();
}

bool MatchLimits::clock_stands() const {
  return steps_ - moved_.steps > longest_wait(options_.server) &&
         seconds_since(moved_at_) > options_.stall_after_s;
}

MatchLimits::Clock::duration MatchLimits::skip_standstill(Clock::time_point now) {
  const Clock::duration gap = watch_.check(now);
  start_ += gap;
  moved_at_ += gap;
  if (last_cycle_) *last_cycle_ += gap;
  stood_still_ += gap;
  return gap;
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
  if (clock_stands()) return EndReason::kStalled;
  return std::nullopt;
}

std::string MatchLimits::describe(EndReason reason) const {
  switch (reason) {
    case EndReason::kInterrupted:
      return "interrupted";
    case EndReason::kTimedOut:
      return fmt::format("the time limit of {} s was reached", options_.time_limit_s.value_or(0));
    case EndReason::kRefused:
      return fmt::format("no answer within the start limit of {} s (--start-timeout)",
                         options_.start_timeout_s);
    default:
      if (clock_stands()) {
        return fmt::format("the game clock has stood still at cycle {} in {} for {} steps",
                           moved_.match.cycle, soccer::name(moved_.match.mode),
                           steps_ - moved_.steps);
      }
      return fmt::format("no new cycle for {} s", options_.stall_after_s);
  }
}

}  // namespace cls::match
