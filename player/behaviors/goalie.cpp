// Goalie: catches, clears, comes out, or takes a position; free kick after a catch.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/behaviors/goalie_save.h"
#include "player/looking/looking.h"
#include "player/movement/movement.h"
#include "player/planner/plan_execution.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"

namespace cls::player {
namespace {

constexpr double kGoalX = kOwnGoal.x;

std::optional<Shot> shot_at_us(const WorldModel& world) {
  const Vec2 velocity = world.ball.velocity;
  if (!world.ball.velocity_valid() || velocity.x > -0.1) return std::nullopt;

  const double half_mouth = world.server().goal_width / 2.0 + 1.5;
  Vec2 before = world.ball.position;

  for (int cycle = 1; cycle <= kMaxShotCycles; ++cycle) {
    const Vec2 now = ball_after(world, cycle);
    if (now.x <= kGoalX) {
      const double share = (before.x - kGoalX) / std::max(1e-9, before.x - now.x);
      const double y = before.y + (now.y - before.y) * share;
      if (std::fabs(y) > half_mouth) return std::nullopt;
      return Shot{y, cycle};
    }
    before = now;
  }

  return std::nullopt;
}

/// True if the ball rolled past a teammate that has tackled since: that counts as a pass too.
bool comes_from_tackle(const WorldModel& world) {
  if (!world.server().back_passes || !world.ball.velocity_valid()) return false;

  constexpr double kReach = 2.3;
  constexpr int kMaxCycles = 100;  // a faulty server may send more
  const int cycles = std::min(world.server().tackle_cycles, kMaxCycles);

  return std::ranges::any_of(world.teammates, [&](const PlayerState& teammate) {
    if (!teammate.tackling || teammate.ghost()) return false;
    Vec2 ball = world.ball.position;
    Vec2 step = world.ball.velocity;
    for (int cycle = 0; cycle <= cycles; ++cycle) {
      if (distance(ball, teammate.position) < kReach) return true;
      step = step / world.server().ball_decay;
      ball -= step;
    }
    return false;
  });
}

bool can_catch(const WorldModel& world) {
  constexpr double kInset = 1.0;
  constexpr double kSure = 0.8;

  const PlayMode mode = without_side(world.game.mode);
  const bool penalty = mode == PlayMode::kPenaltyTakenLeft;
  if (mode != PlayMode::kPlayOn && !penalty) return false;
  if (!in_own_penalty_area(world.ball.position, kInset) && !penalty) return false;
  if (world.self.catch_probability <= 0.0 || (is_back_pass(world) && !penalty)) return false;

  // Unless it is a shot: it may have been the touch of an opponent.
  if (comes_from_tackle(world) && !shot_at_us(world) && !penalty) return false;
  // Maximum angle of a catch: 90 degrees plus the width of the catch area.
  constexpr double kMaxCatchAngle = 108.0;
  if ((world.ball.angle_from_self - world.self.body).abs() > kMaxCatchAngle) return false;

  if (world.self.catch_probability >= kSure * world.server().catch_probability) return true;
  // Last chance for a shot that passes by.
  const std::optional<Shot> shot = shot_at_us(world);
  return shot && distance(ball_after(world, 1), self_after(world, 1)) > world.ball.dist_from_self;
}

bool is_across(const WorldModel& world) { return world.planner->goalie_across != 0; }

bool should_come_out(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  const int self = table.best_self_steps();
  if (self >= kNever || world.kickable_teammate()) return false;

  const Vec2 meeting = ball_after(world, self);
  const Vec2 next = ball_after(world, 1);
  const bool in_mouth = next.x < -44.5 && std::fabs(next.y) < 10.0;
  const int opponent = table.first_opponent_steps;

  // Against an opponent with the ball, coming out opens the goal.
  constexpr int kDuel = 1;
  if (in_mouth && self <= (world.kickable_opponent() ? kDuel : opponent + 1)) return true;
  if (const std::optional<Shot> shot = shot_at_us(world)) {
    // A pass along the goal: the opponent who gets it shoots.
    const bool pass =
        is_across(world) && !world.kickable_opponent() && opponent < std::min(self, shot->cycles);
    return !pass;
  }
  if (!in_own_penalty_area(meeting, 0.5)) return false;
  // Stay if a teammate gets the ball in time.
  if (table.first_teammate_steps < self && table.first_teammate_steps < opponent) return false;

  return self < opponent || (world.ball.dist_from_self < 3.0 && self <= opponent + 1);
}

/// Point on the line of a shot that the goalie reaches before the ball.
Vec2 blocking_point(const WorldModel& world, const Shot& shot) {
  Highest<Vec2> best{-1e9, {kGoalX + 0.5, shot.y}};

  for (int cycle = 1; cycle <= shot.cycles; ++cycle) {
    const Vec2 ball = ball_after(world, cycle);
    if (ball.x < kGoalX + 0.3) break;
    const double run = kBehaviors.goalie.run_speed * cycle;
    best.offer(-(distance(ball, world.self.position) - run), ball);
  }

  return best.value;
}

bool chase(ActionContext& c) {
  const WorldModel& world = c.world;
  c.neck.kind = NeckPlan::Kind::kBall;

  constexpr double kTackle = 0.8;
  const bool dangerous = world.kickable_opponent() || shot_at_us(world).has_value();
  if (dangerous && world.self.catch_probability <= 0.0 && basic_tackle(world, c.slots, kTackle)) {
    return true;
  }

  const int self = world.intercept.best_self_steps();
  const std::optional<Shot> shot = shot_at_us(world);
  const bool fast = world.ball.velocity.length() > kBehaviors.save.shot_speed;
  if (is_across(world) && shot && fast && save_shot(c, *shot)) return true;
  if (self < kNever && (!shot || self <= shot->cycles)) {
    return intercept(world, c.slots, false, {0.0, world.ball.position.y});
  }

  if (!shot) return false;
  // Ball outside the catch angle: turn toward it.
  const AngleDeg next_ball = AngleDeg::of(ball_after(world, 1) - self_after(world, 1));
  const double beside = (next_ball - world.self.body).degrees();
  constexpr double kReach = 1.5;
  if (distance(ball_after(world, 1), self_after(world, 1)) < kReach && std::fabs(beside) > 100.0) {
    return c.slots.turn(beside);
  }

  const Vec2 block = blocking_point(world, *shot);
  if (!go_to_point(world, c.slots, block, 0.2, world.server().max_dash_power, {2, 20.0, false})) {
    turn_to_ball(world, c.slots);
  }
  return c.slots.has_body();
}

/// Body direction while waiting: between the ball and the more open side of the goal, so that
/// dashes go there and balls on both sides can be caught; the nearer the ball, the more toward it.
AngleDeg waiting_body(const WorldModel& world, Vec2 ball) {
  const Vec2 here = world.self.position;
  const AngleDeg to_ball = AngleDeg::of(ball - here);
  const bool middle = std::fabs(here.y) < 1.0;
  const double side =
      middle ? (world.self.body.degrees() >= 0.0 ? 1.0 : -1.0) : (here.y < 0.0 ? 1.0 : -1.0);

  constexpr double kCloseBall = 13.0;
  const double max_angle = distance(ball, here) < kCloseBall ? 15.0 : 55.0;
  const double off = (AngleDeg(90.0 * side) - to_ball).degrees();
  return to_ball + std::clamp(off, -max_angle, max_angle);
}

bool wait_in_position(ActionContext& c, Vec2 ball) {
  const WorldModel& world = c.world;
  const AngleDeg error = waiting_body(world, ball) - world.self.body;
  constexpr double kNear = 8.0;
  if (error.abs() > kNear) return c.slots.turn(error.degrees());
  return stop_dash(world, c.slots, true) || c.slots.turn(0.0);
}

bool go_to_position(ActionContext& c) {
  const WorldModel& world = c.world;
  constexpr SaveParameters kSave = kBehaviors.save;
  const int ahead = is_across(world) ? kSave.look_ahead : 5;
  const int steps =
      std::min({ahead, world.intercept.first_opponent_steps, world.intercept.first_teammate_steps});
  const Vec2 ball = ball_after(world, steps);
  const Vec2 position = goalie_position(world, ball);
  c.neck.kind = ball.x > 0.0 ? NeckPlan::Kind::kBallOrScan : NeckPlan::Kind::kBall;

  const double away = distance(position, world.self.position);
  if (is_across(world) && away < kSave.slides && distance(ball, kOwnGoal) < kSave.range) {
    return slide(c, position, ball);
  }
  const bool hurry = ball.x < -20.0;
  const double threshold = hurry ? 0.4 : 1.0;
  if (away < threshold) return wait_in_position(c, ball);

  const double power = hurry ? world.server().max_dash_power : 60.0;
  return go_to_point(world, c.slots, position, threshold, safe_dash_power(world, power), {4}) ||
         wait_in_position(c, ball);
}

/// Candidate position farthest from opponents.
Vec2 roomiest_position(const WorldModel& world) {
  static constexpr std::array<Vec2, 3> kPlaces{{{-43.0, 10.0}, {-43.0, -10.0}, {-43.0, 0.0}}};
  Highest<Vec2> best{-1.0, kPlaces[0]};

  for (const Vec2 position : kPlaces) {
    double room = 100.0;
    for (const PlayerState& opponent : world.opponents) {
      if (opponent.position_valid()) room = std::min(room, distance(opponent.position, position));
    }
    best.offer(room, position);
  }

  return best.value;
}

bool wait(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kScan;
  const Vec2 upfield{0.0, 0.0};
  return body_neck_to_point(c.world, c.memory.view, c.slots, upfield);
}

}  // namespace

bool is_back_pass(const WorldModel& world) {
  return world.server().back_passes && world.last_kick.side == world.our_side &&
         world.last_kick.unum != 0;
}

bool in_own_penalty_area(Vec2 point, double inset) {
  return in_own_box(point, inset) && point.x > kGoalX - 1.0;
}

bool goalie_move(ActionContext& c) {
  if (c.world.self.frozen()) return false;
  const bool our_set_play = is_set_play_of(c.world.game, c.world.our_side);
  const bool may_touch = !our_set_play && !must_leave_ball(c.world, c.memory);
  if (may_touch && should_come_out(c.world) && chase(c)) return true;
  return go_to_position(c);
}

bool goalie_kick(ActionContext& c) {
  if (!clear_ball(c.world, c.slots)) return false;
  c.neck.kind = NeckPlan::Kind::kScan;
  return true;
}

bool play_goalie(ActionContext& c) {
  if (c.world.self.frozen()) return false;
  if (must_leave_ball(c.world, c.memory)) return goalie_move(c);
  if (can_catch(c.world) && c.slots.catch_ball()) {
    c.neck.kind = NeckPlan::Kind::kBall;
    return true;
  }
  if (c.world.self.kickable && goalie_kick(c)) return true;
  return goalie_move(c);
}

bool goalie_free_kick(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.self.frozen()) return false;

  GoalieKickMemory& memory = c.memory.goalie_kick;
  if (!holds_caught_ball(world)) {
    memory = {};
    return goalie_move(c);
  }
  // After a move the ball estimate is outdated for a while, but the goalie still holds the ball:
  // running would carry it toward our goal.
  if (!world.self.kickable) return neck_body_to_ball(world, c.memory.view, c.slots, 0.0);
  const int since = world.game.time.cycle - std::max(0, world.game.caught_time);
  constexpr int kSettle = 3;
  constexpr int kPatience = 50;  // teammates take positions meanwhile
  constexpr int kAfterMove = 5;
  const int limit = world.server().drop_ball_time - 10;

  if (since < kSettle) return wait(c);
  if (!memory.moved) {
    const bool rested = since >= std::min(kPatience, limit - kAfterMove);
    if (!rested) return wait(c);
    memory.moved = true;
    memory.move_cycle = world.game.time.cycle;
    c.neck.kind = NeckPlan::Kind::kScan;
    if (c.slots.move(roomiest_position(world))) return true;
  }

  const bool seen = world.game.see_time == world.game.time.cycle;
  const bool due = since >= limit;
  if (!due && (world.game.time.cycle - memory.move_cycle < kAfterMove || !seen)) return wait(c);
  return kick_outlet(c);
}

}  // namespace cls::player
