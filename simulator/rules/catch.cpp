// The goalie's hands: where it may catch, and the back pass (9.11).
#include "simulator/referee/areas.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void forget_passers(CatchRule& memory) { memory.passer = memory.passer_before = kNobody; }

void call_back_pass(World& world, Side side, Events& events) {
  world.ball_catcher = kNobody;
  world.referee.catch_ball.counter = 0;
  place_ball(world, for_side(PlayMode::kBackPassLeft, side), opponent(side),
             out_of_goal_area(side, truncated(world.ball.position)), events);
}

void call_catch_fault(World& world, Side side, Events& events) {
  world.ball_catcher = kNobody;
  world.referee.catch_ball.counter = 0;
  place_ball(world, for_side(PlayMode::kCatchFaultLeft, side), opponent(side),
             out_of_penalty_area(side, truncated(world.ball.position)), events);
}

// True if both teams have touched the ball in this cycle: then nobody passed it to anybody.
bool note_touch(World& world, const Player& player) {
  CatchRule& memory = world.referee.catch_ball;
  memory.touched[player.side == Side::kRight ? 1 : 0] = true;
  if (!memory.touched[0] || !memory.touched[1]) return false;
  forget_passers(memory);
  return true;
}

void kick_taken(World& world, Player& kicker, double, Events&) {
  if (note_touch(world, kicker)) return;
  CatchRule& memory = world.referee.catch_ball;
  if (memory.passer != kicker.slot()) {
    memory.passer_before = memory.passer;
    memory.passer = kicker.slot();
  }
  memory.pass_time = world.clock.time;
}

void ball_touched(World& world, Player& player, Events&) { note_touch(world, player); }

void mode_changed(World& world, PlayMode mode, Events&) {
  if (mode != PlayMode::kPlayOn) forget_passers(world.referee.catch_ball);
}

bool is_dead(PlayMode mode) { return is_goal(mode) || mode == PlayMode::kTimeOver; }

bool is_handling(const World& world, const Player& catcher) {
  return !is_dead(world.mode) && !in_penalty_area(catcher.side, world.ball.position);
}

bool back_pass_applies(const World& world, const Player& catcher) {
  const CatchRule& memory = world.referee.catch_ball;
  return world.params().back_passes && !is_dead(world.mode) && memory.passer != kNobody &&
         world.player(memory.passer).side == catcher.side;
}

bool is_opponent(const World& world, Slot slot, const Player& catcher) {
  return slot != kNobody && world.player(slot).side != catcher.side;
}

// The goalie may take again what it had won from an opponent.
bool is_own_ball(const World& world, const Player& catcher) {
  const CatchRule& memory = world.referee.catch_ball;
  return memory.passer == catcher.slot() && is_opponent(world, memory.passer_before, catcher);
}

// A kick and a catch in one cycle are no pass, unless another of the team had the ball before.
bool is_no_pass_yet(const World& world, const Player& catcher) {
  const CatchRule& memory = world.referee.catch_ball;
  return memory.pass_time == world.clock.time &&
         (memory.passer_before == kNobody || is_opponent(world, memory.passer_before, catcher));
}

void punish_back_pass(World& world, const Player& catcher, Events& events) {
  world.player(world.referee.catch_ball.passer).state |= state::kBackPass;
  call_back_pass(world, catcher.side, events);
}

void ball_caught(World& world, Player& catcher, Events& events) {
  if (soccer::is_penalty_mode(world.mode)) return;
  if (is_handling(world, catcher)) {
    call_catch_fault(world, catcher.side, events);
    return;
  }
  if (back_pass_applies(world, catcher) && !is_own_ball(world, catcher) &&
      !is_no_pass_yet(world, catcher)) {
    punish_back_pass(world, catcher, events);
    return;
  }
  forget_passers(world.referee.catch_ball);
  award_free_kick(world, catcher.side, world.ball.position, events);
}

void ball_punched(World& world, Player& catcher, Events& events) {
  if (soccer::is_penalty_mode(world.mode)) return;
  CatchRule& memory = world.referee.catch_ball;
  if (is_handling(world, catcher)) {
    call_catch_fault(world, catcher.side, events);
  } else if (!back_pass_applies(world, catcher) || memory.pass_time == world.clock.time) {
    forget_passers(memory);
  } else if (!is_own_ball(world, catcher)) {
    punish_back_pass(world, catcher, events);
  }
}

void analyse(World& world, Events& events) {
  CatchRule& memory = world.referee.catch_ball;
  memory.touched = {};
  const PlayMode mode = world.mode;
  const bool is_back_pass = is_either(mode, PlayMode::kBackPassLeft);
  if (is_back_pass || is_either(mode, PlayMode::kCatchFaultLeft)) {
    const Side offender = soccer::side(mode);
    if (!wait_out_offence(world, memory.counter, offender, events)) return;
    const PlayMode kick = is_back_pass ? PlayMode::kIndirectFreeKickLeft : PlayMode::kFreeKickLeft;
    change_mode(world, for_side(kick, opponent(offender)), events);
    return;
  }
  if (world.ball_catcher == kNobody) return;
  const Player& catcher = world.player(world.ball_catcher);
  if (is_handling(world, catcher)) call_catch_fault(world, catcher.side, events);
}

}  // namespace

const Rule kCatchRule = {.analyse = analyse,
                         .kick_taken = kick_taken,
                         .ball_touched = ball_touched,
                         .ball_caught = ball_caught,
                         .ball_punched = ball_punched,
                         .mode_changed = mode_changed};

}  // namespace cls::simulator
