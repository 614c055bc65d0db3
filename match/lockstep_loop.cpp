// Cycles, turns and waiting in lockstep.
#include "match/lockstep_loop.h"

#include <fmt/format.h>

#include <algorithm>

#include "match/sides/pace.h"
#include "match/terms/server_settings.h"

namespace cls::match {
namespace {

// The time for which signals and limits may go unnoticed.
constexpr std::chrono::milliseconds kTurnWait{20};

double in_seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

void LockstepLoop::play(const Hooks& hooks) {
  arrange(hooks);
  began_ = Clock::now();
  guard_.begin_cycle();
  while (!guard_.ended() && !is_over()) play_cycle(hooks);
  played_ = Clock::now() - began_;
  times_.play = in_seconds(played_);
}

void LockstepLoop::arrange(const Hooks& hooks) {
  std::vector<EmbeddedServer::Arrange> changes;
  for (MatchHooks* hook : hooks) {
    changes.push_back([hook](simulator::World& world, simulator::Events& events) {
      hook->arrange(world, events);
    });
  }
  server_.begin_play(changes);
}

void LockstepLoop::play_cycle(const Hooks& hooks) {
  const Clock::time_point free = Clock::now();
  throttle();
  guard_.begin_cycle();

  const Clock::time_point begin = Clock::now();
  server_.step([&hooks](simulator::World& world, simulator::Events& events) {
    for (MatchHooks* hook : hooks) hook->after_step(world, events);
  });
  observe();
  const Clock::time_point stepped = Clock::now();
  times_.server += in_seconds(stepped - begin);
  speed_.add_step(begin - free, stepped - begin);

  take_turn(hooks);
  times_.sides += in_seconds(Clock::now() - stepped);

  guard_.check();
  guard_.report_warnings();
  const MatchView after = view();
  for (MatchHooks* hook : hooks) {
    if (!hook->after_cycle(after)) guard_.end({});
  }
}

void LockstepLoop::throttle() const {
  if (!options_.speed) return;
  keep_pace(began_, server_.progress().steps, options_.server.simulator_step, *options_.speed,
            [this] { return guard_.signal() != 0; });
}

void LockstepLoop::observe() {
  guard_.begin_cycle();
  const SourceProgress now = guard_.progress();
  guard_.follow_clock(now);
  guard_.observer().on_cycle(now.match);
  if (const auto line = speed_.estimate(now.match, now.steps, Clock::now() - began_)) {
    guard_.observer().on_notice(*line);
  }
}

MatchView LockstepLoop::view() const {
  const simulator::World& world = server_.world();
  return {.progress = guard_.progress().match,
          .stoppage = world.clock.stoppage,
          .ball = world.ball.position,
          .world = &world};
}

void LockstepLoop::take_turn(const Hooks& hooks) {
  const MatchView view = this->view();
  for (MatchHooks* hook : hooks) hook->before_decisions(view);
  if (!hooks.empty()) guard_.begin_cycle();

  const Clock::time_point begin = Clock::now();
  for (const auto& side : sides_) {
    if (TurnTaker* turns = side->turns()) turns->begin_turn(view.progress.cycle);
  }
  for (const auto& side : sides_) {
    if (TurnTaker* turns = side->turns()) turns->take_turn();
  }
  wait_for_decisions();
  wait_for_external_clients();
  guard_.begin_cycle();  // every reply is in: the stall limit must not expire after this
  speed_.add_turns(Clock::now() - begin);

  for (const auto& side : sides_) {
    if (TurnTaker* turns = side->turns()) turns->end_turn();
  }
}

void LockstepLoop::wait_for_decisions() {
  for (const auto& side : sides_) {
    TurnTaker* turns = side->turns();
    if (turns == nullptr) continue;
    guard_.wait_for(*side, [turns] { return turns->wait_turn(kTurnWait); });
  }
  if (!guard_.ended()) return;

  cancel_calls();
  for (const auto& side : sides_) {
    if (TurnTaker* turns = side->turns()) turns->wait_turn(TurnTaker::kNoLimit);
  }
}

// External clients have as long as a Playmaker, and may miss as many cycles.
void LockstepLoop::wait_for_external_clients() {
  if (guard_.ended()) return;
  const auto found = std::ranges::find_if(sides_, is_external);
  if (found == sides_.end()) return;

  const MatchSide& external = **found;
  const auto deadline = reply_timeout(options_);
  const Clock::time_point begin = Clock::now();
  bool done = false;
  const bool waited = guard_.wait_for(external, [&] {
    done = server_.wait_for_commands(kTurnWait);
    return done || (deadline && Clock::now() >= begin + *deadline);
  });
  if (!waited) return;

  if (!done) server_.count_missed_cycle();
  missed_by_external_ = done ? 0 : missed_by_external_ + 1;
  if (missed_by_external_ <= options_.max_missed) return;
  guard_.end(
      {.reason = EndReason::kLate,
       .message = fmt::format("{}: not all players sent (done) in {} cycles in a row, up to cycle "
                              "{}",
                              external.who(), missed_by_external_, guard_.moment().cycle),
       .fault = external.identity().side});
}

void LockstepLoop::cancel_calls() {
  for (const auto& side : sides_) side->cancel();
}

std::optional<SpeedResult> LockstepLoop::speed(const MatchResult& result) {
  return speed_.result(played_, result);
}

}  // namespace cls::match
