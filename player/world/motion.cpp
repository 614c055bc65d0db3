// Noise-free motion.
#include "player/world/motion.h"

#include <algorithm>
#include <cmath>

namespace cls::player {

Vec2 speed_limited(Vec2 velocity, double max) {
  const double squared = velocity.squared_length();
  return squared > max * max ? velocity * (max / std::sqrt(squared)) : velocity;
}

double power_of(double base, int exponent) {
  double result = 1.0;
  for (double square = base; exponent > 0; exponent >>= 1, square *= square) {
    if ((exponent & 1) != 0) result *= square;
  }
  return result;
}

Vec2 coast(Vec2 position, Vec2 velocity, double decay, int cycles) {
  return position + velocity * ((1.0 - power_of(decay, cycles)) / (1.0 - decay));
}

Vec2 rest_point(Vec2 position, Vec2 velocity, double decay) {
  return position + velocity / (1.0 - decay);
}

double first_speed(double distance, int cycles, double decay) {
  return distance * (1.0 - decay) / (1.0 - power_of(decay, cycles));
}

double turn_resistance(const soccer::PlayerType& type, Vec2 velocity) {
  return 1.0 + type.inertia_moment * velocity.length();
}

double max_turn(const WorldModel& world) {
  return world.server().maxmoment / turn_resistance(world.self_type(), world.self.velocity);
}

Vec2 dash_acceleration(const WorldModel& world, AngleDeg body, double power, double direction) {
  const double size = world.self.effort * power * dash_rate(world.server(), direction) *
                      world.self_type().dash_power_rate;
  return speed_limited(soccer::polar(size, body + direction), world.server().player_accel_max);
}

Vec2 dash_acceleration(const WorldModel& world, double power, double direction) {
  return dash_acceleration(world, world.self.body, power, direction);
}

double safe_dash_power(const WorldModel& world, double power) {
  const double threshold = world.server().recover_dec_thr * world.server().stamina_max + 1.0;
  const double available = world.self.capacity == 0.0
                               ? world.self.stamina + world.self_type().extra_stamina
                               : world.self.stamina - threshold;
  return std::clamp(available, 0.0, std::max(power, 0.0));
}

double kickable_area(const WorldModel& world) {
  return world.self_type().kickable_area(world.server().ball_size);
}

double collide_distance(const WorldModel& world) {
  return world.self_type().player_size + world.server().ball_size;
}

double kick_rate(const WorldModel& world, Vec2 relative, AngleDeg body) {
  const soccer::PlayerType& type = world.self_type();
  const double off = (AngleDeg::of(relative) - body).abs() / 180.0;
  const double gap = (relative.length() - collide_distance(world)) / type.kickable_margin;
  return std::max(0.0001, type.kick_power_rate * (1.0 - 0.25 * off - 0.25 * gap));
}

Vec2 self_after(const WorldModel& world, int cycles) {
  return coast(world.self.position, world.self.velocity, world.self_type().player_decay, cycles);
}

Vec2 ball_after(const WorldModel& world, int cycles) {
  return coast(world.ball.position, world.ball.velocity, world.server().ball_decay, cycles);
}

Vec2 ball_after(Vec2 position, Vec2 velocity, int cycles, double decay) {
  for (int i = 0; i < cycles; ++i) {
    position += velocity;
    velocity *= decay;
  }
  return position;
}

Vec2 first_reach_point(const WorldModel& world) {
  const int steps = std::min(world.intercept.our_steps(), world.intercept.first_opponent_steps);
  return steps >= kNever ? world.ball.position : ball_after(world, steps);
}

}  // namespace cls::player
