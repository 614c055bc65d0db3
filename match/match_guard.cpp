// Limits and failures compared with what the match waits for.
#include "match/match_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "match/match_fault.h"

namespace cls::match {
namespace {

// A signal to a group of processes reaches all of them within this time.
constexpr std::chrono::milliseconds kSignalSpread{100};
// The match reports a reply that it has waited for this long.
constexpr std::chrono::seconds kSlowReply{3};

}  // namespace

// ---- ends

void MatchGuard::end(MatchEnd end) {
  if (ended()) return;
  if (end.reason == EndReason::kServerFailed && !end.fault) blame_excess(end);
  if (row_of(end.reason).traits.by_intruder) {
    if (const auto intruder = server_.intruder()) {
      end.fault = intruder->side;
      end.message += "; " + intruder->evidence;
    }
  }
  end_ = std::move(end);
}

void MatchGuard::attribute(const MatchSide& side, MatchEnd& end) {
  const bool victim = end.fault_unknown || end.reason == EndReason::kServerFailed;
  if (!is_trainer(side) && !victim) end.fault = side.identity().side;
}

void MatchGuard::end_by_side(const MatchSide& side, MatchEnd end) {
  attribute(side, end);
  end_unless_interrupted(std::move(end));
}

void MatchGuard::end_unless_interrupted(MatchEnd end) {
  if (limits_.interrupted_within(kSignalSpread)) return;
  this->end(std::move(end));
  loop_->on_failure();
}

// A server, or the other side, may fail for want of what a side has taken.
void MatchGuard::blame_excess(MatchEnd& end) const {
  for (const auto& side : sides_) {
    const std::string excess = side->excess(true);
    if (excess.empty() || is_trainer(*side)) continue;
    end.fault = side->identity().side;
    end.message += fmt::format("; {}: {}", side->who(), excess);
    return;
  }
}

// The server may continue without a side whose Playmaker hangs: that is a stall, too.
std::optional<EndReason> MatchGuard::exceeded_limit() const {
  if (const auto limit = limits_.exceeded()) return limit;
  if (!playing_ || options_.no_deadline) return std::nullopt;

  const std::chrono::duration<double> stall_limit =
      std::chrono::duration<double>(options_.stall_after_s) + limits_.stood_still();
  if (sides_awaited_for(sides_, stall_limit).empty()) return std::nullopt;
  return EndReason::kStalled;
}

void MatchGuard::end_by_stall() {
  // Those that kept the match waiting for most of the limit. In lockstep the match knows which side
  // it waits for; over UDP each side plays on its own.
  auto awaited =
      sides_awaited_for(sides_, std::chrono::duration<double>(options_.stall_after_s / 2));
  if (awaited.empty() && awaited_.side != nullptr) awaited.push_back(awaited_.side);

  MatchEnd end{.reason = EndReason::kStalled, .message = limits_.describe(EndReason::kStalled)};
  if (limits_.clock_stands()) return this->end(std::move(end));
  if (!awaited.empty()) {
    end.message = stall_message(awaited, moment().cycle, end.message);
  } else {
    const bool external = std::ranges::any_of(sides_, is_external);
    end.message += fmt::format("; no Playmaker is awaited: the soccer server{} has stopped",
                               external ? " or an external team" : "");
  }

  if (awaited.size() == 1) blame(*awaited.front(), moment(), end);
  this->end(std::move(end));
}

void MatchGuard::end_by_limit(EndReason limit) {
  if (limit == EndReason::kStalled) return end_by_stall();

  MatchEnd end{.reason = limit, .message = limits_.describe(limit)};
  if (limit == EndReason::kRefused && awaited_.what) {
    const std::string hint = awaited_.side == nullptr ? "" : awaited_.side->timeout_hint();
    end.message = fmt::format("{} within the start limit of {} s (--start-timeout){}",
                              awaited_.what(), options_.start_timeout_s, hint);
    if (awaited_.side != nullptr && loop_->blames(*awaited_.side)) {
      blame(*awaited_.side, moment(), end);
    }
    if (!end.failure && awaited_.child != nullptr) end.failure = failure_of(*awaited_.child);
  }
  this->end(std::move(end));
}

// ---- checks

void MatchGuard::check_sides() {
  for (const auto& side : sides_) {
    if (ended() || !loop_->needs_sides()) return;
    auto failure = side->failure(moment());
    if (!failure) continue;
    // A program that gets no more processes or space may end before the match looks.
    if (const std::string excess = side->excess(true); !excess.empty()) {
      failure->message += fmt::format("; {}", excess);
    }
    end_by_side(*side, *std::move(failure));
  }
}

void MatchGuard::check_excess() {
  for (const auto& side : sides_) {
    if (ended() || !loop_->needs_sides()) return;
    const std::string excess = side->excess(false);
    if (excess.empty()) continue;
    end_by_side(*side, {.reason = playing_ ? EndReason::kCrashed : EndReason::kRefused,
                        .message = fmt::format("{}: {}", side->who(), excess)});
  }
}

void MatchGuard::check() {
  if (ended()) return;
  check_excess();
  if (ended()) return;

  if (const auto gap = limits_.skip_standstill(); gap > gap.zero()) {
    warn(
        fmt::format("cls stood still for {:.0f} s (stopped and continued, or a host that did not "
                    "run it): limits count from here",
                    std::chrono::duration<double>(gap).count()));
  }
  if (auto failure = server_.failure(playing_)) {
    if (failure->reason == EndReason::kLate) {
      blame_unresponsive(sides_, server_.status().awaited_s, *failure);
    }
    end_unless_interrupted(*std::move(failure));
  }
  check_sides();
  if (ended()) return;

  if (playing_) warn_of_slow_reply();
  if (const auto limit = exceeded_limit()) end_by_limit(*limit);
}

void MatchGuard::start_server() {
  if (ended()) return;
  awaited_ = {.what = [this] { return server_.waiting_for(); }};
  auto failure = server_.start([this] {
    awaited_.child = server_.child();
    check();
    return !ended();
  });
  awaited_ = {};
  if (failure) end(*std::move(failure));
}

bool MatchGuard::wait_for(const MatchSide& side, const std::function<bool()>& reached) {
  awaited_ = {.what = [&side] { return side.waiting_for(); },
              .side = &side,
              .child = side.awaited_process()};
  while (!ended() && !reached()) {
    if (!playing_) server_.wait_for_clients();
    awaited_.child = side.awaited_process();
    check();
  }
  awaited_ = {};
  return !ended();
}

SourceProgress MatchGuard::progress() const {
  SourceProgress latest = server_.progress();
  for (const auto& side : sides_) {
    const auto seen = side->seen();
    if (!seen) continue;
    latest.steps = std::max(latest.steps, seen->progress.steps);
    if (seen->progress.match.cycle >= latest.match.cycle) latest.match = seen->progress.match;
  }

  const int whole = options_.server.normal_time_cycles();
  latest.match.last_cycle = whole;
  if (options_.cycles) {
    latest.match.last_cycle = whole > 0 ? std::min(whole, *options_.cycles) : *options_.cycles;
  }
  return latest;
}

// ---- warnings

// Says who is awaited before the stall limit ends the match.
void MatchGuard::warn_of_slow_reply() {
  if (options_.no_deadline) return;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto call = sides_[i]->awaited_reply();
    if (!call || call->waited < kSlowReply || std::exchange(warned_of_slow_reply_[i], true)) {
      continue;
    }
    warn(fmt::format("{}: no reply to {} for {} s at cycle {}", sides_[i]->identity().name,
                     describe(*call), kSlowReply.count(), moment().cycle));
  }
}

void MatchGuard::warn(std::string line) {
  observer_->on_warning(line);
  warnings_.push_back(std::move(line));
}

void MatchGuard::report_warnings() {
  for (std::string& line : server_.take_warnings()) warn(std::move(line));
  for (const auto& side : sides_) {
    for (const std::string& line : side->take_warnings()) {
      warn(fmt::format("{}: {}", side->identity().name, line));
    }
  }
}

}  // namespace cls::match
