// Life of a match: start, join, handshake, play, end, result.
#include "match/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "match/match_fault.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

constexpr std::chrono::milliseconds kHandshakeWait{20};

bool has_missed(const PlayerResult& agent) { return agent.missed > 0 || agent.reconnects > 0; }

}  // namespace

Match::Match(const MatchOptions& options, std::unique_ptr<Server> server, Sides sides,
             const MakeLoop& make_loop, std::uint64_t seed, const std::atomic<int>& stop_signal)
    : options_(options),
      seed_(seed),
      server_(std::move(server)),
      sides_(std::move(sides)),
      guard_(options, *server_, sides_, stop_signal),
      loop_(make_loop(sides_, guard_)) {
  guard_.follow(*loop_);
}

void Match::add_hooks(MatchHooks& hooks) {
  hooks_.push_back(&hooks);
  for (const auto& side : sides_) {
    if (is_trainer(*side)) continue;
    SideListener* listener = hooks.listener(side->identity().side);
    if (listener != nullptr) side->listen(*listener);
  }
}

void Match::play(MatchObserver& observer) {
  guard_.report_to(observer);
  loop_->prepare();
  start_server();
  join_sides();
  shake_hands();
  guard_.report_warnings();

  if (!guard_.ended()) {
    guard_.begin_play();
    for (const auto& side : sides_) side->begin_play();
    loop_->play(hooks_);
  }

  finish();
  make_result();
}

// ---- start

void Match::start_server() {
  guard_.start_server();
  const std::string monitor = server_->monitor_address();
  if (!guard_.ended() && !monitor.empty()) {
    guard_.observer().on_notice(fmt::format("monitors may attach at {}", monitor));
  }
}

void Match::join_sides() {
  std::vector<std::string> joined;
  for (const auto& side : sides_) {
    if (guard_.ended()) return;
    guard_.observer().on_phase(fmt::format("{} joins", side->identity().name));
    guard_.wait_for(*side, [&] {
      if (auto failure = side->join(server_->status(), joined)) {
        if (loop_->blames(*side)) MatchGuard::attribute(*side, *failure);
        guard_.end(*std::move(failure));
      }
      return side->joined();
    });
    joined.push_back(side->team_name());
  }

  // A side alone waits for its Playmaker with a limit of its own.
  if (sides_.size() == 1) guard_.begin_cycle();
}

void Match::shake_hands() {
  for (const auto& side : sides_) {
    if (guard_.ended()) return;
    side->begin_handshake();
    if (!side->wait_handshake(kHandshakeWait)) {
      guard_.observer().on_phase(fmt::format("waiting for {}", side->who()));
      guard_.wait_for(*side, [&side] { return side->wait_handshake(kHandshakeWait); });
    }
    guard_.check();
  }
}

// ---- end

void Match::finish() {
  guard_.end({});
  loop_->finish(guard_.how());
  for (const auto& side : sides_) side->leave();
  for (const auto& side : sides_) side->terminate();
  for (const auto& side : sides_) {
    for (const std::string& line : side->failed_expectations()) {
      guard_.warn(fmt::format("{}: {}", side->identity().name, line));
    }
  }

  processes_ = server_->wait_gone();
  for (const auto& side : sides_) {
    for (ProcessResult& process : side->wait_gone()) processes_.push_back(std::move(process));
  }
}

std::vector<AgentProgress> Match::agent_progress() const {
  std::vector<AgentProgress> all;
  for (const auto& side : sides_) {
    if (const auto seen = side->seen()) all.push_back({side->identity().name, seen->progress});
  }
  return all;
}

void Match::add_sides() {
  for (const auto& side : sides_) {
    TeamResult team = side->result();
    if (std::ranges::any_of(team.players, has_missed) || (team.coach && team.coach->missed > 0)) {
      result_.deterministic = false;
    }
    if (is_trainer(*side)) {
      result_.trainer = team.coach;
    } else {
      result_.team(side->identity().side) = std::move(team);
    }
  }
}

void Match::make_result() {
  result_.mode = name(loop_->mode());
  result_.seed = seed_;
  result_.server_kind = options_.server_choice.text;
  add_sides();

  const MatchEnd& end = guard_.how();
  result_.end_reason = end.reason;
  result_.message = end.message;
  result_.failure = end.failure;
  result_.fault = end.fault;
  result_.try_again = end.try_again;
  result_.signal = guard_.signal();
  result_.processes = std::move(processes_);

  const std::vector<std::string>& warnings = guard_.warnings();
  result_.warnings = warnings;
  server_->add_result(result_, agent_progress());
  for (std::size_t i = warnings.size(); i < result_.warnings.size(); ++i) {
    guard_.observer().on_warning(result_.warnings[i]);
  }

  const double seconds = loop_->times().play;
  if (seconds > 0.0) result_.cycles_per_second = result_.cycles / seconds;
  result_.speed = loop_->speed(result_);
  if (result_.end_reason == EndReason::kTimedOut) blame_for_time();
}

// The limit says nothing of who took the time; the shares do.
void Match::blame_for_time() {
  const std::optional<soccer::Side> slow = side_of_most_time(result_.speed);
  if (!slow) return;
  for (const auto& side : sides_) {
    if (side->identity().side != *slow) continue;
    result_.fault = *slow;
    result_.message += fmt::format("; {} took {:.0f} % of the time", side->who(),
                                   share_of(*result_.speed, *slow) * 100.0);
    const ProcessorTime own = processor_time(result_.processes, *slow);
    const ProcessorTime others = processor_time(result_.processes, soccer::opponent(*slow));
    if (!was_starved(own, others)) continue;
    result_.fault = soccer::opponent(*slow);
    result_.message += fmt::format(
        ", but waited {:.1f} s for a processor: its programs had {:.1f} s of CPU time, those of "
        "the other side {:.1f} s",
        own.delayed_s, own.used_s, others.used_s);
  }
}

}  // namespace cls::match
