// Positions and roles in set plays.

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "player/behaviors/behaviors.h"
#include "player/movement/home_positions.h"
#include "player/movement/movement.h"
#include "player/movement/off_ball.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

double running_power(ActionContext& c) {
  const WorldModel& world = c.world;
  const double rest = std::max(0.0, world.self_type().stamina_inc_max * world.self.recovery);
  const double half = 0.5 * world.server().stamina_max;
  return world.self.stamina > half ? std::min(world.server().max_dash_power, 2.0 * rest) : rest;
}

/// Runs to the position and faces the ball there.
bool go_to_position(ActionContext& c, Vec2 position) {
  const WorldModel& world = c.world;
  const double threshold = std::clamp(0.07 * world.ball.dist_from_self, 0.7, 2.0);
  c.neck.kind = NeckPlan::Kind::kBallOrScan;
  const double power = safe_dash_power(world, running_power(c));
  if (go_to_point(world, c.slots, position, threshold, power)) return true;
  turn_to_ball(world, c.slots);
  return c.slots.has_body();
}

/// Moves a position outside the forbidden circle around the ball.
Vec2 clear_of_ball(Vec2 position, Vec2 ball) {
  constexpr double kClearance = 11.0;
  const Vec2 relative = position - ball;
  if (relative.length() >= kClearance) return position;

  // Toward our goal, so that the position is not behind the ball.
  Vec2 way = relative;
  way.x = std::min(way.x, -0.5 * std::fabs(way.y) - 0.1);
  Vec2 out = ball + soccer::with_length(way, kClearance);
  if (std::fabs(out.y) > soccer::kHalfWidth) {
    out.y = std::copysign(soccer::kHalfWidth, out.y);
    out.x = ball.x -
            std::sqrt(std::max(0.0, kClearance * kClearance - (out.y - ball.y) * (out.y - ball.y)));
  }

  // The point must not be behind the goal line.
  out.x = std::max(out.x, -soccer::kHalfLength + 0.5);
  return out;
}

/// Intermediate target around the forbidden circle.
Vec2 around_circle(Vec2 from, Vec2 to, Vec2 ball) {
  constexpr double kRadius = soccer::kCenterCircleRadius + 0.6;
  if (distance(from, ball) < kRadius) return ball + soccer::with_length(from - ball, kRadius + 1.0);

  if (distance(soccer::Segment{from, to}, ball) > kRadius) return to;
  const Vec2 way = to - from;
  const double side = cross(way, ball - from) > 0.0 ? 1.0 : -1.0;
  return ball + soccer::with_length(Vec2{way.y, -way.x} * side, kRadius + 1.5);
}

bool their_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  const TeamPoints homes = home_positions(world);
  Vec2 position = homes[base::index(world.unum - 1)];
  const PlayMode kind = without_side(world.game.mode);

  if (kind == PlayMode::kKickOffLeft) {
    position.x = std::min(position.x, -0.5);
  } else if (kind == PlayMode::kGoalKickLeft) {
    constexpr double kOffBox = soccer::kHalfLength - soccer::kPenaltyAreaLength - 0.8;
    if (std::fabs(position.y) < soccer::kPenaltyAreaWidth / 2.0 + 0.8) {
      position.x = std::min(position.x, kOffBox);
    }
    // After the kick the ball may be intercepted.
    const InterceptTable& table = world.intercept;
    const bool rolls = world.ball.velocity.length() > 0.2;
    const Vec2 meeting = ball_after(world, std::min(table.best_self_steps(), 50));
    if (rolls && meeting.x < kOffBox && table.best_self_steps() < table.first_teammate_steps) {
      return intercept(world, c.slots, true, kOpponentGoal);
    }
    return go_to_position(c, position);
  }

  std::optional<Mark> mark;
  if (kind != PlayMode::kKickOffLeft) mark = find_mark(world, homes, kSetPlayMarking);
  if (mark) position = mark->point;

  position = clear_of_ball(position, world.ball.position);
  if (!go_to_position(c, around_circle(world.self.position, position, world.ball.position))) {
    return false;
  }

  constexpr int kMaxAge = 2;  // an opponent out of sight would be forgotten
  if (mark && mark->opponent->pos_count > kMaxAge && world.ball.pos_count <= kMaxAge) {
    c.neck = {NeckPlan::Kind::kPoint, mark->opponent->position};
  }
  return true;
}

/// Sidesteps periodically to get away from a marker.
Vec2 shake_off(const WorldModel& world, Vec2 position) {
  const bool marked = std::ranges::any_of(world.opponents, [&](const PlayerState& opponent) {
    return opponent.pos_count <= 5 && distance(opponent.position, world.self.position) < 3.0;
  });

  const int phase = world.game.time.cycle / 20 % 2;
  if (!marked || world.self.stamina < 0.6 * world.server().stamina_max) return position;
  position.y += phase == 0 ? 3.0 : -3.0;
  position.y = std::clamp(position.y, -soccer::kHalfWidth + 1.0, soccer::kHalfWidth - 1.0);
  return position;
}

/// A kicked ball is still in set play mode until it leaves the area or the referee reacts: fetches
/// it, unless the agent is the goalie or the kicker.
bool fetch_kicked_ball(ActionContext& c) {
  const WorldModel& world = c.world;
  constexpr double kRolls = 0.3;
  const InterceptTable& table = world.intercept;
  const bool rolls = world.ball.vel_count <= 1 && world.ball.velocity.length() > kRolls;
  const bool own_kick =
      world.last_kick.side == world.our_side && world.last_kick.unum == world.unum;

  if (own_kick || !rolls || world.self.kickable || table.best_self_steps() >= kNever) return false;
  const PlayerState* first = world.player_by_id(table.first_teammate_id);
  const bool goalie_first = first != nullptr && first->goalie;
  const int others = goalie_first ? table.second_teammate_steps : table.first_teammate_steps;

  if (table.best_self_steps() > others) return false;
  c.neck.kind = NeckPlan::Kind::kBall;
  return intercept(world, c.slots, true, kOpponentGoal);
}

bool our_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  Vec2 position = own_home_position(world);
  if (world.game.goalie_catch) return go_to_position(c, position);
  if (set_play_kicker(world) == world.unum) return kick_set_play(c);

  const PlayMode kind = without_side(world.game.mode);
  if (kind == PlayMode::kGoalKickLeft) return go_to_position(c, position);

  if (kind == PlayMode::kKickOffLeft) {
    position.x = std::min(position.x, -0.5);
  } else {
    position = shake_off(world, position);
    const bool no_offside = kind == PlayMode::kKickInLeft || kind == PlayMode::kCornerKickLeft;
    if (!no_offside) position.x = std::min(position.x, world.lines.offside - 0.5);
  }

  // Say "wait" to the kicker while far from the position or tired.
  const int since = world.game.time.cycle - world.game.last_set_play_start;
  const bool far = distance(world.self.position, position) > 12.0;
  const bool tired = world.self.stamina < 0.45 * world.server().stamina_max;
  constexpr int kAskUntil = 50;
  if ((far || tired) && since < kAskUntil) c.slots.say("w");

  return go_to_position(c, position);
}

}  // namespace

bool play_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.self.frozen()) return false;

  const bool is_ours = is_set_play_of(world.game, world.our_side);
  if (world.goalie) {
    return is_ours && world.game.goalie_catch ? goalie_free_kick(c) : goalie_move(c);
  }
  if (is_ours) return fetch_kicked_ball(c) || our_set_play(c);
  if (is_set_play_of(world.game, world.their_side())) return their_set_play(c);
  return basic_move(c);
}

}  // namespace cls::player
