// Selects directions for long kicks.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "player/ball_skills/skill_parameters.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr ClearParameters kNumbers = kSkills.clear;
constexpr double kTargetDistance = 30.0;  ///< of the point that a long kick aims at, meters

/// Score of a direction: large if opponents are far from the ball's line.
double advance_score(const WorldModel& world, AngleDeg direction) {
  constexpr double kConeDeg = 30.0;
  double score = 1000.0;
  const Vec2 way = soccer::polar(1.0, direction);

  for (const PlayerState& opponent : world.opponents) {
    if (opponent.ghost() || !opponent.position_valid()) continue;
    const Vec2 relative = opponent.position - world.ball.position;
    if ((AngleDeg::of(relative) - direction).abs() > kConeDeg) continue;
    const double along = std::max(0.1, dot(relative, way));
    const double beside = std::fabs(cross(way, relative));
    score *= std::max(0.0, beside - kNumbers.reach) / along;
    if (opponent.pos_count > 3) score *= power_of(kNumbers.fading, opponent.pos_count - 3);
  }

  return score;
}

/// Minimum angle between the direction and an opponent near enough to stop the ball.
double free_angle(const WorldModel& world, AngleDeg direction) {
  constexpr double kFar = 30.0;
  double gap = 180.0;
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.ghost() || opponent.pos_count > 20 || opponent.dist_from_ball > kFar) continue;
    gap = std::min(gap, (opponent.angle_from_ball - direction).abs());
  }
  return gap;
}

/// First direction in order of preference that `visit` accepts.
template <typename Visit>
std::optional<AngleDeg> first_direction(Vec2 ball, const Visit& visit) {
  const double side = ball.y < 0.0 ? -1.0 : 1.0;
  for (double ahead = 50.0; ahead >= 20.0; ahead -= 5.0) {
    const Vec2 point{std::min(ball.x + ahead, soccer::kHalfLength), side * soccer::kHalfWidth};
    const AngleDeg direction = AngleDeg::of(point - ball);
    if (visit(direction)) return direction;
  }

  for (const double off : {30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 25.0, 20.0,
                           15.0, 10.0, 5.0, 0.0}) {
    for (const double sign : {side, -side}) {
      if (visit(AngleDeg(sign * off))) return AngleDeg(sign * off);
    }
  }

  return std::nullopt;
}

AngleDeg clear_direction(const WorldModel& world) {
  double min_angle = kNumbers.free_angle;
  for (int attempt = 0; attempt < 5; ++attempt, min_angle *= kNumbers.narrower) {
    const auto direction = first_direction(world.ball.position, [&](AngleDeg candidate) {
      return free_angle(world, candidate) >= min_angle;
    });
    if (direction) return *direction;
  }
  return AngleDeg::of(world.ball.position - kOwnGoal);
}

bool opponent_within(const WorldModel& world, double radius) {
  return std::ranges::any_of(world.opponents, [&](const PlayerState& opponent) {
    return opponent.position_valid() && opponent.dist_from_ball < radius;
  });
}

}  // namespace

bool advance_ball(const WorldModel& world, CommandSlots& slots) {
  if (!world.self.kickable) return false;

  Highest<AngleDeg> best{-1.0};
  for (double off = 0.0; off <= 65.0; off += 6.5) {
    for (const double sign : {1.0, -1.0}) {
      best.offer(advance_score(world, AngleDeg(sign * off)), AngleDeg(sign * off));
    }
  }

  const double max = world.server().ball_speed_max;
  const Vec2 target = world.ball.position + soccer::polar(kTargetDistance, best.value);
  const double one_kick =
      max_speed_along(world.ball.velocity, soccer::polar(1.0, best.value), kick_limit(world), max);

  const bool sequence =
      world.game.mode == PlayMode::kPlayOn && !(one_kick >= kNumbers.single_kick * max);
  if (sequence && smart_kick(world, slots, target, max, kNumbers.advance_threshold * max, 3)) {
    return true;
  }
  return kick_one_step(world, slots, target, max, true);
}

bool clear_ball(const WorldModel& world, CommandSlots& slots) {
  if (!world.self.kickable) return false;
  const double max = world.server().ball_speed_max;
  if (world.kickable_opponent()) {
    return kick_one_step(world, slots, world.ball.position + Vec2{10.0, 0.0}, max, true);
  }

  const Vec2 target = world.ball.position + soccer::polar(kTargetDistance, clear_direction(world));
  if (world.game.mode == PlayMode::kPlayOn && !opponent_within(world, 1.5) &&
      smart_kick(world, slots, target, max,
                 std::max(kNumbers.min_clear_speed, kNumbers.clear_threshold * max), 2)) {
    return true;
  }

  return kick_one_step(world, slots, target, max, true);
}

bool force_kick(const WorldModel& world, CommandSlots& slots) {
  if (world.game.mode != PlayMode::kPlayOn || world.goalie) return false;
  if (!world.self.kickable || !world.kickable_opponent()) return false;
  const Vec2 here = world.self.position;
  const bool wing = std::fabs(here.y) > 10.0;
  Vec2 target{wing && here.x > 36.0 ? 45.0 : soccer::kHalfLength, 0.0};

  // The opponent kicks too, before our goal most likely inwards.
  if (wing && here.x < -30.0) target = {here.x + 10.0, std::copysign(soccer::kHalfWidth, here.y)};
  return kick_one_step(world, slots, target, world.server().ball_speed_max, true);
}

}  // namespace cls::player
