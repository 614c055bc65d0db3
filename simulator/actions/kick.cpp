// kick: strongest and most accurate when the ball is close and in front
// (docs/spec/simulation-model.md 4.4).
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/referee/referee.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator::actions {

namespace math = soccer::math;

void kick(World& world, Player& player, const soccer::Kick& command, Events& events) {
  if (player.command_done) return;
  player.command_done = true;
  player.kick_cycles = 1;
  player.state |= state::kKick;
  if (ball_is_dead(world.mode)) {
    player.state |= state::kKickFault;
    return;
  }
  if (!is_kickable(world, player)) {
    player.state |= state::kKickFault;
    on_ball_missed(world, player.slot(), events);
    return;
  }

  const soccer::ServerParams& server = world.params();
  const soccer::PlayerType& type = world.type_of(player);
  const double power = soccer::between(command.power, server.minpower, server.maxpower);
  const double direction =
      exact_radians(soccer::between(command.direction, server.minmoment, server.maxmoment));
  const Vec2 to_ball = world.ball.position - player.position;
  // 0 is the best value of both; the gap is negative while the ball overlaps the player.
  const double angle_off =
      std::fabs(math::normalize_radians(soccer::direction_radians(to_ball) - player.body)) /
      math::kPi;
  const double gap =
      (to_ball.length() - type.player_size - server.ball_size) / type.kickable_margin;

  const double strength = power * type.kick_power_rate * (1.0 - 0.25 * angle_off - 0.25 * gap);
  Vec2 push = soccer::polar_radians(strength, direction + player.body);
  const double noise_rate = 0.5 + 0.25 * (angle_off + gap) + ball_speed_noise_rate(world);
  push += ball_noise(world, kick_rand(world, player) * (power / server.maxpower) * noise_rate,
                     world.random.kick_noise[static_cast<std::size_t>(player.slot())]);

  world.ball_catcher = kNoPlayer;
  world.ball.acceleration += push;
  ++player.counters.kick;
  on_kick_taken(world, player.slot(), push.length(), events);
}

}  // namespace cls::simulator::actions
