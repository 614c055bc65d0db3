// Helpers shared by several commands.
#include "simulator/actions/commands.h"

#include <cmath>

namespace cls::simulator::actions {

namespace math = soccer::math;

void occupy_legs(Player& player) {
  for (Leg& leg : player.legs) leg = {true, false, 0.0, 0.0};
}

Vec2 ball_relative_to(const World& world, const Player& player, double direction) {
  return soccer::rotated_radians(world.ball.position - player.position, -direction);
}

bool ball_is_dead(PlayMode mode) { return soccer::mode_class(mode) != soccer::ModeClass::kRunning; }

Vec2 ball_noise(World& world, double radius, RandomStream& stream) {
  const double length = stream.uniform(0.0, radius);
  const double direction = stream.uniform(-math::kPi, math::kPi);
  if (world.overrides) {
    world.overrides->push_noise_max += std::fabs(radius);
    world.overrides->push_noise_mean2 += radius * radius / 3.0;
    return {};
  }
  return soccer::polar_radians(length, direction);
}

double kick_rand(const World& world, const Player& player) {
  const soccer::ServerParams& server = world.params();
  const double rand = world.type_of(player).kick_rand;
  if (!server.team_actuator_noise) return rand;
  return rand *
         (player.side == Side::kLeft ? server.kick_rand_factor_l : server.kick_rand_factor_r);
}

double ball_speed_noise_rate(const World& world) {
  const soccer::ServerParams& server = world.params();
  return 0.5 + 0.5 * world.ball.velocity.length() / (server.ball_speed_max * server.ball_decay);
}

}  // namespace cls::simulator::actions
