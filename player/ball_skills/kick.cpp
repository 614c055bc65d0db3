// Computes single kicks.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <cmath>

#include "player/world/motion.h"
#include "soccer/interval.h"

namespace cls::player {

double kick_limit(const WorldModel& world, double rate) {
  return std::min(world.server().maxpower * rate, world.server().ball_accel_max);
}

double kick_limit(const WorldModel& world) { return kick_limit(world, world.self.kick_rate); }

double max_speed_along(Vec2 velocity, Vec2 direction, double limit, double speed_max) {
  const double across = cross(velocity, direction);
  const double rest = limit * limit - across * across;
  if (rest < 0.0) return -1.0;
  return std::min(dot(velocity, direction) + std::sqrt(rest), speed_max);
}

namespace {

double power_for(const WorldModel& world, Vec2 change) {
  return std::min(change.length(), kick_limit(world)) / world.self.kick_rate;
}

bool kick_by(const WorldModel& world, CommandSlots& slots, Vec2 change) {
  return slots.kick(power_for(world, change), (AngleDeg::of(change) - world.self.body).degrees());
}

/// Change of the ball's velocity that stops it beside the agent.
Vec2 stopping_change(const WorldModel& world) {
  const Vec2 velocity = world.ball.known_velocity();
  const Vec2 relative = world.ball.position - world.self.position;
  const double dist = relative.length();
  const double gap =
      soccer::between(dist, collide_distance(world) + 0.1, kickable_area(world) - 0.1);
  const Vec2 outwards = dist > 1e-6 ? relative / dist : soccer::polar(1.0, world.self.body);

  const Vec2 next_self = self_after(world, 1);
  Vec2 desired = next_self + outwards * gap - world.ball.position;
  if ((desired - velocity).length() > kick_limit(world)) {
    // Too fast to stop: reduce the speed and let the ball come closer.
    desired = next_self + outwards * (collide_distance(world) + 0.1) - world.ball.position;
  }

  return desired - velocity;
}

constexpr double kWorthwhilePower = 0.5;

}  // namespace

bool kick_to_velocity(const WorldModel& world, CommandSlots& slots, Vec2 velocity) {
  return kick_by(world, slots, velocity - world.ball.velocity);
}

bool kick_one_step(const WorldModel& world, CommandSlots& slots, Vec2 target, double first_speed,
                   bool force_mode) {
  if (!world.self.kickable) return false;
  if (!world.ball.velocity_valid() && !force_mode) return stop_ball(world, slots);

  const Vec2 way = target - world.ball.position;
  const double length = way.length();
  const double desired = soccer::between(first_speed, 0.0, world.server().ball_speed_max);
  if (length < 1e-6 || desired < 1e-6) return stop_ball(world, slots);

  const Vec2 direction = way / length;
  const double limit = kick_limit(world);
  const double possible =
      max_speed_along(world.ball.velocity, direction, limit, world.server().ball_speed_max);
  const double speed = std::min(desired, possible);

  const bool reachable =
      speed > 0.0 && (direction * speed - world.ball.velocity).length() <= limit + 1e-9;
  if (reachable || force_mode) {
    return kick_to_velocity(world, slots, direction * (reachable ? speed : desired));
  }

  return hold_ball(world, slots, false, {});
}

bool stop_needs_kick(const WorldModel& world) {
  return power_for(world, stopping_change(world)) >= kWorthwhilePower;
}

bool stop_ball(const WorldModel& world, CommandSlots& slots) {
  if (!world.self.kickable) return false;

  const Vec2 needed = stopping_change(world);
  if (!(power_for(world, needed) < kWorthwhilePower)) return kick_by(world, slots, needed);
  slots.turn(0.0);
  return false;
}

}  // namespace cls::player
