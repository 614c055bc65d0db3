// The ball over the lines: goals, corners, goal kicks and kick-ins (9.9).
#include <cmath>

#include "simulator/referee/calls.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/rule.h"
#include "simulator/rules/touch.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

constexpr int kGoalWait = 50;

double goal_line(const World& world) { return soccer::kHalfLength + world.params().ball_size; }

bool is_over_goal_line(const World& world) {
  return std::fabs(world.ball.position.x) > goal_line(world);
}

bool is_over_touch_line(const World& world) {
  return std::fabs(world.ball.position.y) > soccer::kHalfWidth + world.params().ball_size;
}

void contact(World& world, Player& player, double acceleration, Events&) {
  if (is_over_goal_line(world)) return;
  TouchRule& memory = world.referee.touch;
  const Slot slot = player.slot();
  if (world.mode == PlayMode::kPlayOn && memory.indirect_kicker != kNobody &&
      memory.indirect_kicker != slot) {
    memory.indirect = false;
    memory.indirect_kicker = kNobody;
  }
  if (memory.indirect) memory.indirect_kicker = slot;
  // Of several contacts in a cycle the strongest counts.
  const int now = world.clock.time;
  if (memory.touch_time < now || memory.touch_acceleration <= acceleration) {
    memory.toucher = slot;
    memory.touch_time = now;
    memory.touch_acceleration = acceleration;
  }
}

void ball_touched(World& world, Player& player, Events& events) {
  contact(world, player, 0.0, events);
}

void mode_changed(World& world, PlayMode mode, Events&) {
  TouchRule& memory = world.referee.touch;
  if (mode != PlayMode::kPlayOn) memory.toucher = kNobody;
  if (is_either(mode, PlayMode::kIndirectFreeKickLeft)) {
    memory.indirect = true;
    memory.indirect_kicker = kNobody;
  } else if (mode != PlayMode::kPlayOn && mode != PlayMode::kDropBall) {
    memory.indirect = false;
  }
}

bool can_score(const World& world, Side defender) {
  if (is_goal(world.mode) || world.mode == PlayMode::kTimeOver) return false;
  if (world.referee.touch.indirect) return false;
  const bool held_by_attacker =
      world.ball_catcher != kNobody && world.player(world.ball_catcher).side != defender;
  return !held_by_attacker && crossed_goal_line(world, defender, world.referee.touch.previous_ball);
}

void score_goal(World& world, Side scorer, Events& events) {
  const Rules& rules = *world.rules;
  Team& team = world.team(scorer);
  ++team.score;
  announce(world, {"goal", scorer, team.score}, events);
  place_ball(world, opponent(scorer), world.ball.position);
  world.referee.touch.counter = 0;
  const bool decides =
      rules.half_time >= 0 && rules.server.golden_goal && world.clock.time >= rules.normal_time;
  change_mode(world, decides ? PlayMode::kTimeOver : for_side(PlayMode::kGoalLeft, scorer), events);
}

void leave_over_goal_line(World& world, Events& events) {
  const Side defender = world.ball.position.x < 0.0 ? Side::kLeft : Side::kRight;
  const Slot toucher = world.referee.touch.toucher;
  if (toucher != kNobody && world.player(toucher).side == defender) {
    award_corner_kick(world, opponent(defender), events);
  } else if (world.ball_catcher == kNobody) {
    award_goal_kick(world, defender, events);
  }
}

void leave_over_touch_line(World& world, Events& events) {
  const Slot toucher = world.referee.touch.toucher;
  if (toucher == kNobody) {
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

void look_at_lines(World& world, Events& events) {
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
    leave_over_goal_line(world, events);
  } else if (is_over_touch_line(world)) {
    leave_over_touch_line(world, events);
  }
}

void analyse(World& world, Events& events) {
  look_at_lines(world, events);
  world.referee.touch.previous_ball = world.ball.position;
}

}  // namespace

bool crossed_goal_line(const World& world, Side defender, Vec2 before) {
  const Vec2 now = world.ball.position;
  const double line = goal_line(world);
  const double width = world.params().goal_width / 2.0 + soccer::kGoalPostRadius;
  if (before.x == now.x || std::fabs(now.x) <= line || std::fabs(before.x) > line ||
      sign(defender) * now.x >= 0.0 ||
      (std::fabs(before.y) > width && std::fabs(before.x) > soccer::kHalfLength)) {
    return false;
  }
  const double x = -sign(defender) * line;
  const double y = before.y + (now.y - before.y) * (x - before.x) / (now.x - before.x);
  return std::fabs(y) <= width;
}

const Rule kTouchRule = {.analyse = analyse,
                         .kick_taken = contact,
                         .ball_touched = ball_touched,
                         .mode_changed = mode_changed};

}  // namespace cls::simulator
