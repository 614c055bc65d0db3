// Catch, clear, come out, or stand well.
#include "proxy/behaviors/goalie.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "proxy/ball_skills/clear_ball.h"
#include "proxy/behaviors/goalie_place.h"
#include "proxy/movement/intercept.h"
#include "proxy/movement/movement.h"
#include "proxy/movement/tackle.h"
#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::PlayMode;
using soccer::Vec2;

constexpr double kGoalX = -soccer::kHalfLength;

/// Where and when a rolling ball crosses our goal line, if it does so between the posts.
struct Shot {
  double y = 0.0;
  int cycles = 0;
};

std::optional<Shot> shot_at_us(const WorldModel& world) {
  const Vec2 velocity = world.ball.velocity;
  if (!world.ball.velocity_valid() || velocity.x > -0.1) return std::nullopt;
  constexpr int kLongest = 40;
  const double half_mouth = world.server().goal_width / 2.0 + 1.5;
  Vec2 before = world.ball.position;
  for (int cycle = 1; cycle <= kLongest; ++cycle) {
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

/// A ball that a teammate passed back on purpose must not be caught.
bool forbidden_to_catch(const WorldModel& world) {
  return world.server().back_passes && world.last_kick.side == world.our_side &&
         world.last_kick.unum != world.unum && world.last_kick.unum != 0;
}

bool can_catch(const WorldModel& world) {
  constexpr double kInset = 1.0;
  constexpr double kSure = 0.8;
  const PlayMode mode = world.game.mode;
  const bool penalty = mode == PlayMode::kPenaltyTakenLeft || mode == PlayMode::kPenaltyTakenRight;
  if (mode != PlayMode::kPlayOn && !penalty) return false;
  if (!in_own_penalty_area(world.ball.position, kInset) && !penalty) return false;
  if (world.self.catch_probability <= 0.0 || (forbidden_to_catch(world) && !penalty)) return false;
  // Arms reach a quarter turn to either side, and the width of the catch area beyond that.
  constexpr double kArms = 108.0;
  if ((world.ball.angle_from_self - world.self.body).abs() > kArms) return false;
  if (world.self.catch_probability >= kSure * world.server().catch_probability) return true;
  // Now or never: a shot that passes by.
  const std::optional<Shot> shot = shot_at_us(world);
  return shot && distance(ball_after(world, 1), self_after(world, 1)) > world.ball.dist_from_self;
}

bool wants_to_come_out(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  const int self = table.best_self_steps();
  if (self >= kNever || world.kickable_teammate()) return false;
  const Vec2 meeting = ball_after(world, self);
  const Vec2 next = ball_after(world, 1);
  const bool in_mouth = next.x < -44.5 && std::fabs(next.y) < 10.0;
  const int opponent = table.first_opponent_steps;
  // With the ball at an opponent's feet whoever runs at him leaves the goal open behind himself.
  constexpr int kDuel = 1;
  if (in_mouth && self <= (world.kickable_opponent() ? kDuel : opponent + 1)) return true;
  if (shot_at_us(world)) return true;
  if (!in_own_penalty_area(meeting, 0.5)) return false;
  // Teammates there in time leave the goalie where he belongs.
  if (table.first_teammate_steps < self && table.first_teammate_steps < opponent) return false;
  return self < opponent || (world.ball.dist_from_self < 3.0 && self <= opponent + 1);
}

/// The point of a shot's line that the goalie can be at before the ball.
Vec2 blocking_point(const WorldModel& world, const Shot& shot) {
  const double speed = 0.8;  // what a goalie covers in a cycle of a short run
  Vec2 best{kGoalX + 0.5, shot.y};
  double best_margin = -1e9;
  for (int cycle = 1; cycle <= shot.cycles; ++cycle) {
    const Vec2 ball = ball_after(world, cycle);
    if (ball.x < kGoalX + 0.3) break;
    const double missing = distance(ball, world.self.position) - speed * cycle;
    if (-missing > best_margin) {
      best_margin = -missing;
      best = ball;
    }
  }
  return best;
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
  if (self < kNever && (!shot || self <= shot->cycles)) {
    return intercept(world, c.slots, false, {0.0, world.ball.position.y});
  }
  if (!shot) return false;
  // A ball behind the arms: turn to it while it comes.
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

/// Half towards the ball, half towards where more of the goal is open: dashes go there, and balls
/// on either side can be caught. The nearer the ball, the more towards it.
AngleDeg waiting_body(const WorldModel& world, Vec2 ball) {
  const Vec2 here = world.self.position;
  const AngleDeg to_ball = AngleDeg::of(ball - here);
  const bool middle = std::fabs(here.y) < 1.0;
  const double side =
      middle ? (world.self.body.degrees() >= 0.0 ? 1.0 : -1.0) : (here.y < 0.0 ? 1.0 : -1.0);
  constexpr double kCloseBall = 13.0;
  const double most = distance(ball, here) < kCloseBall ? 15.0 : 55.0;
  const double off = (AngleDeg(90.0 * side) - to_ball).degrees();
  return to_ball + std::clamp(off, -most, most);
}

bool stand(ActionContext& c, Vec2 ball) {
  const WorldModel& world = c.world;
  const AngleDeg error = waiting_body(world, ball) - world.self.body;
  constexpr double kNear = 8.0;
  if (error.abs() > kNear) return c.slots.turn(error.degrees());
  return stop_dash(world, c.slots, true) || c.slots.turn(0.0);
}

bool take_place(ActionContext& c) {
  const WorldModel& world = c.world;
  const int steps =
      std::min({5, world.intercept.first_opponent_steps, world.intercept.first_teammate_steps});
  const Vec2 ball = ball_after(world, steps);
  const Vec2 place = goalie_place(world, ball);
  c.neck.kind = ball.x > 0.0 ? NeckPlan::Kind::kBallOrScan : NeckPlan::Kind::kBall;
  const double away = distance(place, world.self.position);
  const bool hurry = ball.x < -20.0;
  const double threshold = hurry ? 0.4 : 1.0;
  if (away < threshold) return stand(c, ball);
  const double power = hurry ? world.server().max_dash_power : 60.0;
  if (!go_to_point(world, c.slots, place, threshold, safe_dash_power(world, power), {4})) {
    return stand(c, ball);
  }
  return true;
}

}  // namespace

bool in_own_penalty_area(Vec2 point, double inset) {
  return point.x < kGoalX + soccer::kPenaltyAreaLength - inset &&
         std::fabs(point.y) < soccer::kPenaltyAreaWidth / 2.0 - inset && point.x > kGoalX - 1.0;
}

bool goalie_move(ActionContext& c) {
  if (c.world.self.frozen()) return false;
  const bool dead_ball_of_ours = is_set_play_of(c.world.game, c.world.our_side);
  if (!dead_ball_of_ours && wants_to_come_out(c.world) && chase(c)) return true;
  return take_place(c);
}

bool goalie_kick(ActionContext& c) {
  if (!clear_ball(c.world, c.slots)) return false;
  c.neck.kind = NeckPlan::Kind::kScan;
  return true;
}

bool play_goalie(ActionContext& c) {
  if (c.world.self.frozen()) return false;
  if (can_catch(c.world) && c.slots.catch_ball()) {
    c.neck.kind = NeckPlan::Kind::kBall;
    return true;
  }
  if (c.world.self.kickable && goalie_kick(c)) return true;
  return goalie_move(c);
}

}  // namespace cls::proxy
