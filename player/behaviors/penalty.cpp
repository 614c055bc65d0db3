// Roles in a penalty shoot-out: taker, goalie, waiting players.

#include <algorithm>

#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/behaviors.h"
#include "player/looking/looking.h"
#include "player/movement/movement.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

const PlayerState* their_goalie(const WorldModel& world) {
  const PlayerState* found = std::ranges::find_if(
      world.opponents, [](const PlayerState& p) { return p.goalie && p.position_valid(); });
  return found != world.opponents.end() ? found : nullptr;
}

int left_in_mode(const WorldModel& world, int wait) {
  return wait - (world.game.time.cycle - world.game.penalty.cycle);
}

/// Hard shot at the post farther from the goalie.
bool shoot_beside_goalie(ActionContext& c, double threshold) {
  const WorldModel& world = c.world;
  const PlayerState* goalie = their_goalie(world);
  const double post = world.server().goal_width / 2.0 - 1.0;
  const double goalie_y = goalie == nullptr ? 0.0 : goalie->position.y;
  const Vec2 target{soccer::kHalfLength, goalie_y > 0.0 ? -post : post};

  const double max = world.server().ball_speed_max;
  c.neck = {NeckPlan::Kind::kPoint, target};
  return smart_kick(world, c.slots, target, max, threshold * max, 2) ||
         kick_one_step(world, c.slots, target, max, true);
}

/// Waits behind the ball without touching it.
bool wait_behind_ball(ActionContext& c) {
  const WorldModel& world = c.world;
  const Vec2 ball = world.ball.position;
  const Vec2 position = ball - Vec2{collide_distance(world) + 0.35, 0.0};
  c.neck.kind = NeckPlan::Kind::kBall;
  if (go_to_point(world, c.slots, position, 0.25, safe_dash_power(world, 60.0), {10})) return true;
  return turn_to_point(world, c.slots, kOpponentGoal) || c.slots.turn(0.0);
}

bool start_kick(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) return wait_behind_ball(c);

  const bool fit = world.self.stamina > 0.9 * world.server().stamina_max;
  const bool due = left_in_mode(world, world.server().pen_ready_wait) <= 3;
  if (!fit && !due) return wait_behind_ball(c);

  if (!world.server().pen_allow_mult_kicks) return shoot_beside_goalie(c, 0.9);
  // A short kick ahead to dribble.
  c.neck.kind = NeckPlan::Kind::kGoalieOrScan;
  return kick_one_step(world, c.slots, kOpponentGoal, 1.0, true);
}

/// Dribble target around a goalie that comes out, on the side with more space.
Vec2 dribble_target(const WorldModel& world) {
  const PlayerState* goalie = their_goalie(world);
  const Vec2 here = world.ball.position;
  if (goalie == nullptr) return {soccer::kHalfLength - 3.0, 0.0};

  const Vec2 relative = goalie->position - here;
  constexpr double kComing = 12.0;
  if (relative.x < 0.0 || relative.length() > kComing) {
    return {soccer::kHalfLength - 5.0, 0.5 * here.y};
  }

  const double side = relative.y > 0.0 ? -1.0 : 1.0;
  return goalie->position + Vec2{2.0, side * 7.0};
}

bool take_kick(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) {
    c.neck.kind = NeckPlan::Kind::kBall;
    return continue_dribble(world, c.memory.intention, c.slots) ||
           intercept(world, c.slots, false, kOpponentGoal);
  }
  if (!world.server().pen_allow_mult_kicks) return false;

  Vec2 aim;
  if (shoot(world, c.slots, &aim)) {
    c.neck = {NeckPlan::Kind::kPoint, aim};
    return true;
  }

  constexpr int kLastChance = 25;
  const bool late = left_in_mode(world, world.server().pen_taken_wait) < kLastChance;
  const double to_goal = distance(world.ball.position, kOpponentGoal);
  if (late || to_goal < 7.0) return shoot_beside_goalie(c, 0.85);

  c.neck.kind = NeckPlan::Kind::kGoalieOrScan;
  const DribbleOptions options{1.0, world.server().max_dash_power, 4, true};
  return dribble(world, c.memory.intention, c.slots, dribble_target(world), options);
}

bool play_taker(ActionContext& c) {
  switch (without_side(c.world.game.mode)) {
    case PlayMode::kPenaltyReadyLeft:
      return start_kick(c);
    case PlayMode::kPenaltyTakenLeft:
      return take_kick(c) || wait_behind_ball(c);
    default:
      return wait_behind_ball(c);
  }
}

bool play_penalty_goalie(ActionContext& c) {
  const WorldModel& world = c.world;
  c.neck.kind = NeckPlan::Kind::kBall;
  if (without_side(world.game.mode) == PlayMode::kPenaltyTakenLeft) return play_goalie(c);

  const double allowed = std::max(0.5, world.server().pen_max_goalie_dist_x - 1.0);
  const Vec2 position{-soccer::kHalfLength + std::min(allowed, 2.0), 0.0};
  if (go_to_point(world, c.slots, position, 0.5, safe_dash_power(world, 80.0), {10})) return true;
  return turn_to_ball(world, c.slots) || c.slots.turn(0.0);
}

/// Waits in the center circle.
bool wait_in_circle(ActionContext& c) {
  const WorldModel& world = c.world;
  const Vec2 position{-2.0, -9.8 + 1.5 * world.unum};
  c.neck.kind = NeckPlan::Kind::kBallOrScan;
  if (go_to_point(world, c.slots, position, 1.0, safe_dash_power(world, 50.0))) return true;
  return turn_to_ball(world, c.slots) || c.slots.turn(0.0);
}

}  // namespace

bool is_penalty_taker(const WorldModel& world) {
  const PenaltyState& penalty = world.game.penalty;
  return penalty.taker == world.our_side &&
         default_penalty_taker(std::max(1, penalty.our_taken)) == world.unum;
}

bool play_penalty(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!soccer::is_penalty_mode(world.game.mode) || world.self.frozen()) return false;

  const bool our_kick = world.game.penalty.taker == world.our_side;
  if (our_kick && is_penalty_taker(world)) return play_taker(c);
  if (world.goalie && !our_kick) return play_penalty_goalie(c);
  if (world.goalie) {
    c.neck.kind = NeckPlan::Kind::kBall;
    return neck_body_to_ball(world, c.memory.view, c.slots, 0.0);
  }

  return wait_in_circle(c);
}

}  // namespace cls::player
