// Polling a match over UDP.
#include "match/live_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "match/terms/server_settings.h"

namespace cls::match {

// On a server that cls did not start, its operator has chosen the mode.
MatchMode LiveLoop::mode() const {
  MatchMode mode = mode_of(options_);
  if (options_.server_choice.kind != ServerChoice::Kind::kAddress) return mode;
  for (const auto& side : sides_) {
    if (const auto seen = side->seen()) mode = seen->mode;
  }
  return mode;
}

// ---- start

void LiveLoop::warn_of_deadline() {
  const auto deadline = decision_deadline(options_);
  if (!has_agents(options_) || mode_of(options_) != MatchMode::kSynch || !deadline) return;
  if (*deadline <= kServerWait) return;

  guard_.warn(
      fmt::format("--rpc-deadline {} ms: a soccer server in synchronous mode continues "
                  "without a reply after {} ms",
                  deadline->count(), kServerWait.count()));
}

// A Playmaker that takes long to start must not make the players on the pitch wait for it.
void LiveLoop::prepare() {
  warn_of_deadline();
  for (const auto& side : sides_) {
    if (guard_.ended() || side->prepared()) continue;
    guard_.observer().on_phase(fmt::format("waiting for {}", side->who()));
    guard_.wait_for(*side, [&side] { return side->prepared(); });
  }
  if (!guard_.ended()) guard_.observer().on_phase("waiting for the soccer server");
}

// ---- cycles

void LiveLoop::play(const Hooks& hooks) {
  guard_.observer().on_phase("playing");
  began_ = stepped_at_ = Clock::now();
  guard_.begin_cycle();

  while (!guard_.ended() && !is_over()) {
    server_.poll();
    observe();
    const bool turn = turn_is_due();
    if (turn) take_turn(hooks);

    guard_.check();
    guard_.report_warnings();
    report_disconnects();
    if (!turn) continue;
    const MatchView after = view();
    for (MatchHooks* hook : hooks) {
      if (!hook->after_cycle(after)) guard_.end({});
    }
  }

  played_ = Clock::now() - began_;
  end_by_final_failure();
}

void LiveLoop::observe() {
  const SourceProgress now = guard_.progress();
  if (now.steps > steps_) {
    steps_ = now.steps;
    stepped_at_ = Clock::now();
  }
  if (Clock::now() - stepped_at_ < server_.quiet_time()) guard_.begin_cycle();
  if (now.match.cycle > 0) {
    last_cycle_ = Clock::now();
    if (first_cycle_ == Clock::time_point{}) first_cycle_ = last_cycle_;
  }

  guard_.follow_clock(now);
  guard_.observer().on_cycle(now.match);
  if (const auto line = speed_.estimate(now.match, steps_, Clock::now() - began_)) {
    guard_.observer().on_notice(*line);
  }
}

MatchView LiveLoop::view() const {
  MatchView view;
  view.progress = guard_.progress().match;
  for (const auto& side : sides_) {
    const auto seen = side->seen();
    if (seen && !view.ball) view.ball = seen->ball;
  }
  return view;
}

bool LiveLoop::takes_turns() const {
  return std::ranges::any_of(sides_, [](const auto& side) { return side->turns() != nullptr; });
}

bool LiveLoop::turn_is_due() const {
  return takes_turns() && std::ranges::all_of(sides_, [](const auto& side) {
           const TurnTaker* turns = side->turns();
           return turns == nullptr || turns->at_turn();
         });
}

void LiveLoop::take_turn(const Hooks& hooks) {
  const MatchView view = this->view();
  for (MatchHooks* hook : hooks) hook->before_decisions(view);
  if (!hooks.empty()) guard_.begin_cycle();
  for (const auto& side : sides_) {
    if (TurnTaker* turns = side->turns()) turns->begin_turn(view.progress.cycle);
  }
}

// Agents that leave because the match has ended are not reported.
void LiveLoop::report_disconnects() {
  if (is_over() || guard_.ended()) return;
  for (const ReportedConnections& team : server_.status().teams) {
    std::size_t& reported = reported_disconnects_[team.name];
    const std::vector<int> left(team.disconnected.begin() + static_cast<std::ptrdiff_t>(reported),
                                team.disconnected.end());
    reported = team.disconnected.size();
    if (left.empty()) continue;

    guard_.warn(fmt::format("player{} {} of {} left the match at cycle {}",
                            left.size() == 1 ? "" : "s", fmt::join(left, ", "), team.name,
                            guard_.moment().cycle));
  }
}

// ---- end

bool LiveLoop::has_seen(bool SeenMatch::*what) const {
  return std::ranges::any_of(sides_, [what](const auto& side) {
    const auto seen = side->seen();
    return seen && *seen.*what;
  });
}

bool LiveLoop::at_cycle_limit() const {
  return options_.cycles && (server_.progress().match.cycle >= *options_.cycles ||
                             has_seen(&SeenMatch::at_cycle_limit));
}

bool LiveLoop::is_over() const {
  return server_.finished() || at_cycle_limit() || has_seen(&SeenMatch::finished);
}

void LiveLoop::end_by_final_failure() {
  for (const auto& side : sides_) {
    if (guard_.ended()) return;
    if (auto failure = side->final_failure(guard_.moment())) {
      guard_.end_by_side(*side, *std::move(failure));
    }
  }
}

void LiveLoop::finish(const MatchEnd& end) {
  const bool over = end.reason == EndReason::kFinished && is_over();
  // The server makes no further step while it waits for a team at the cycle limit or at its turn.
  const bool held_at_turn = !over && takes_turns();
  using State = ExternalServer::FinalState;
  State state = over ? State::kOver : State::kRunning;
  if (at_cycle_limit() || held_at_turn) state = State::kHeld;

  if (!held_at_turn) {
    for (const auto& side : sides_) side->end_play();
  }
  server_.finish(state, guard_.signal());
}

LoopTimes LiveLoop::times() const {
  return {.play = std::chrono::duration<double>(last_cycle_ - first_cycle_).count()};
}

std::optional<SpeedResult> LiveLoop::speed(const MatchResult& result) {
  speed_.set_awaited(server_.status().awaited_s);
  return speed_.result(played_, result);
}

}  // namespace cls::match
