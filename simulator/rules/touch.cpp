// Touch rule: goals, corner kicks, goal kicks and kick-ins (docs/spec/simulation-model.md 9.9).
#include <cmath>

#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/rule.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

constexpr int kGoalWait = 50;

bool is_over_goal_line(const World& world) {
  return std::fabs(world.ball.position.x) > goal_line(world);
}

bool is_over_touch_line(const World& world) {
  return std::fabs(world.ball.position.y) > soccer::kHalfWidth + world.params().ball_size;
}

void ball_contact(World& world, Player& player, double acceleration, Events&) {
  if (is_over_goal_line(world)) return;
  TouchState& state = world.referee.touch;
  const Slot slot = player.slot();

  if (world.mode == PlayMode::kPlayOn && state.indirect_kicker != kNoPlayer &&
      state.indirect_kicker != slot) {
    state.indirect = false;
    state.indirect_kicker = kNoPlayer;
  }
  if (state.indirect) state.indirect_kicker = slot;

  // Of several contacts in a cycle, the strongest counts.
  const int now = world.clock.time;
  if (state.touch_time < now || state.touch_acceleration <= acceleration) {
    state.toucher = slot;
    state.touch_time = now;
    state.touch_acceleration = acceleration;
  }
}

void ball_touched(World& world, Player& player, Events& events) {
  ball_contact(world, player, 0.0, events);
}

void mode_changed(World& world, PlayMode mode, Events&) {
  TouchState& state = world.referee.touch;
  if (mode != PlayMode::kPlayOn) state.toucher = kNoPlayer;

  if (is_either(mode, PlayMode::kIndirectFreeKickLeft)) {
    state.indirect = true;
    state.indirect_kicker = kNoPlayer;
  } else if (mode != PlayMode::kPlayOn && mode != PlayMode::kDropBall) {
    state.indirect = false;
  }
}

bool can_score(const World& world, Side defender) {
  if (is_goal(world.mode) || world.mode == PlayMode::kTimeOver) return false;
  if (world.referee.touch.indirect) return false;

  const bool held_by_attacker =
      world.ball_catcher != kNoPlayer && world.player(world.ball_catcher).side != defender;
  return !held_by_attacker && crossed_goal_line(world, defender, world.referee.touch.previous_ball);
}

void score_goal(World& world, Side scorer, Events& events) {
  const Rules& rules = *world.rules;
  Team& team = world.team(scorer);
  ++team.score;

  announce(world, {"goal", scorer, team.score}, events);
  place_ball(world, opponent(scorer), world.ball.position);
  world.referee.touch.counter = 0;

  const bool is_golden_goal =
      rules.half_time >= 0 && rules.server.golden_goal && world.clock.time >= rules.normal_time;
  change_mode(world, is_golden_goal ? PlayMode::kTimeOver : for_side(PlayMode::kGoalLeft, scorer),
              events);
}

void call_ball_over_goal_line(World& world, Events& events) {
  const Side defender = world.ball.position.x < 0.0 ? Side::kLeft : Side::kRight;
  const Slot toucher = world.referee.touch.toucher;
  if (toucher != kNoPlayer && world.player(toucher).side == defender) {
    award_corner_kick(world, opponent(defender), events);
  } else if (world.ball_catcher == kNoPlayer) {
    award_goal_kick(world, defender, events);
  }
}

void call_ball_over_touch_line(World& world, Events& events) {
  const Slot toucher = world.referee.touch.toucher;
  if (toucher == kNoPlayer) {
    drop_ball(world, events);
  } else {
    award_kick_in(world, opponent(world.player(toucher).side), events);
  }
}

void wait_after_goal(World& world, Events& events) {
  if (++world.referee.touch.counter <= kGoalWait) return;
  const Side side = opponent(soccer::side(world.mode));
  place_ball(world, for_side(PlayMode::kKickOffLeft, side), side, {}, events);
  keep_players_in_own_half(world);
}

void check_lines(World& world, Events& events) {
  if (soccer::is_penalty_mode(world.mode)) return;

  if (is_goal(world.mode)) {
    wait_after_goal(world, events);
    return;
  }

  if (is_over_goal_line(world)) {
    for (const Side defender : {Side::kLeft, Side::kRight}) {
      if (can_score(world, defender)) {
        score_goal(world, opponent(defender), events);
        return;
      }
    }
    call_ball_over_goal_line(world, events);
  } else if (is_over_touch_line(world)) {
    call_ball_over_touch_line(world, events);
  }
}

void analyze(World& world, Events& events) {
  check_lines(world, events);
  world.referee.touch.previous_ball = world.ball.position;
}

}  // namespace

const Rule kTouchRule = {.analyze = analyze,
                         .kick_taken = ball_contact,
                         .ball_touched = ball_touched,
                         .mode_changed = mode_changed};

}  // namespace cls::simulator
