// Catch rule: catch faults outside the penalty area, and back passes
// (docs/spec/simulation-model.md 9.11).
#include "simulator/referee/areas.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void clear_passers(CatchState& state) { state.passer = state.passer_before = kNoPlayer; }

void call_back_pass(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  world.referee.catch_ball.counter = 0;
  place_ball(world, for_side(PlayMode::kBackPassLeft, side), opponent(side),
             move_out_of_goal_area(side, clamp_to_pitch(world.ball.position)), events);
}

void call_catch_fault(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  world.referee.catch_ball.counter = 0;
  place_ball(world, for_side(PlayMode::kCatchFaultLeft, side), opponent(side),
             move_out_of_penalty_area(side, clamp_to_pitch(world.ball.position)), events);
}

// Returns true if both teams touched the ball in this cycle; then it is not a pass.
bool record_touch(World& world, const Player& player) {
  CatchState& state = world.referee.catch_ball;
  state.touched[player.side == Side::kRight ? 1 : 0] = true;
  if (!state.touched[0] || !state.touched[1]) return false;

  clear_passers(state);
  return true;
}

void kick_taken(World& world, Player& kicker, double, Events&) {
  if (record_touch(world, kicker)) return;
  CatchState& state = world.referee.catch_ball;
  if (state.passer != kicker.slot()) {
    state.passer_before = state.passer;
    state.passer = kicker.slot();
  }
  state.pass_time = world.clock.time;
}

void ball_touched(World& world, Player& player, Events&) { record_touch(world, player); }

void mode_changed(World& world, PlayMode mode, Events&) {
  if (mode != PlayMode::kPlayOn) clear_passers(world.referee.catch_ball);
}

bool is_over(PlayMode mode) { return is_goal(mode) || mode == PlayMode::kTimeOver; }

bool is_outside_penalty_area(const World& world, const Player& catcher) {
  return !is_over(world.mode) && !in_penalty_area(catcher.side, world.ball.position);
}

bool back_pass_applies(const World& world, const Player& catcher) {
  const CatchState& state = world.referee.catch_ball;
  return world.params().back_passes && !is_over(world.mode) && state.passer != kNoPlayer &&
         world.player(state.passer).side == catcher.side;
}

bool is_opponent(const World& world, Slot slot, const Player& catcher) {
  return slot != kNoPlayer && world.player(slot).side != catcher.side;
}

// A goalie may catch a ball again that it won from an opponent.
bool is_own_ball(const World& world, const Player& catcher) {
  const CatchState& state = world.referee.catch_ball;
  return state.passer == catcher.slot() && is_opponent(world, state.passer_before, catcher);
}

// A kick and a catch in one cycle are not a pass unless a teammate kicked the ball before.
bool is_same_cycle_kick(const World& world, const Player& catcher) {
  const CatchState& state = world.referee.catch_ball;
  return state.pass_time == world.clock.time &&
         (state.passer_before == kNoPlayer || is_opponent(world, state.passer_before, catcher));
}

void punish_back_pass(World& world, const Player& catcher, Events& events) {
  world.player(world.referee.catch_ball.passer).state |= state::kBackPass;
  call_back_pass(world, catcher.side, events);
}

void ball_caught(World& world, Player& catcher, Events& events) {
  if (soccer::is_penalty_mode(world.mode)) return;
  if (is_outside_penalty_area(world, catcher)) {
    call_catch_fault(world, catcher.side, events);
    return;
  }

  if (back_pass_applies(world, catcher) && !is_own_ball(world, catcher) &&
      !is_same_cycle_kick(world, catcher)) {
    punish_back_pass(world, catcher, events);
    return;
  }

  clear_passers(world.referee.catch_ball);
  award_free_kick(world, catcher.side, world.ball.position, events);
}

void ball_punched(World& world, Player& catcher, Events& events) {
  if (soccer::is_penalty_mode(world.mode)) return;
  CatchState& state = world.referee.catch_ball;

  if (is_outside_penalty_area(world, catcher)) {
    call_catch_fault(world, catcher.side, events);
  } else if (!back_pass_applies(world, catcher) || state.pass_time == world.clock.time) {
    clear_passers(state);
  } else if (!is_own_ball(world, catcher)) {
    punish_back_pass(world, catcher, events);
  }
}

void analyze(World& world, Events& events) {
  CatchState& state = world.referee.catch_ball;
  state.touched = {};

  const PlayMode mode = world.mode;
  const bool is_back_pass = is_either(mode, PlayMode::kBackPassLeft);
  if (is_back_pass || is_either(mode, PlayMode::kCatchFaultLeft)) {
    const Side offender = soccer::side(mode);
    if (!wait_after_offense(world, state.counter, offender, events)) return;
    const PlayMode kick = is_back_pass ? PlayMode::kIndirectFreeKickLeft : PlayMode::kFreeKickLeft;
    change_mode(world, for_side(kick, opponent(offender)), events);
    return;
  }

  if (world.ball_catcher == kNoPlayer) return;
  const Player& catcher = world.player(world.ball_catcher);
  if (is_outside_penalty_area(world, catcher)) call_catch_fault(world, catcher.side, events);
}

}  // namespace

const Rule kCatchRule = {.analyze = analyze,
                         .kick_taken = kick_taken,
                         .ball_touched = ball_touched,
                         .ball_caught = ball_caught,
                         .ball_punched = ball_punched,
                         .mode_changed = mode_changed};

}  // namespace cls::simulator
