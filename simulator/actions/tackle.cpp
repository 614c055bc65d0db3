// tackle: reaches farther than a kick, may fail, and blocks the player for ten cycles
// (docs/spec/simulation-model.md 4.7).
#include <algorithm>
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/referee/referee.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator::actions {
namespace {

namespace math = soccer::math;

// Clients of version 12 and later send an angle, older clients a power.
constexpr int kFirstVersionWithAngle = 12;

struct Push {
  Vec2 acceleration;
  double power_rate = 1.0;
};

bool opponent_has_ball(const World& world, const Player& player) {
  return std::ranges::any_of(world.players, [&](const Player& other) {
    return other.enabled && other.side != player.side && is_kickable(world, other);
  });
}

double failure_probability(const soccer::ServerParams& server, Vec2 ball, double reach, bool foul) {
  const double exponent = foul ? server.foul_exponent : server.tackle_exponent;
  return math::pow(std::fabs(ball.x) / reach, exponent) +
         math::pow(std::fabs(ball.y) / server.tackle_width, exponent);
}

bool succeeds(World& world, const Player& player, double failure) {
  const Slot slot = player.slot();
  const bool drawn = world.random.tackle[static_cast<std::size_t>(slot)].bernoulli(1.0 - failure);
  return world.overrides ? world.overrides->tackle.replace(slot, drawn, failure > 0.0) : drawn;
}

// Bug in rcssserver: a tackle moves the ball during a catch fault too
// (docs/spec/simulation-model.md 15.2).
bool moves_the_ball(PlayMode mode) {
  return !ball_is_dead(mode) || mode == PlayMode::kCatchFaultLeft ||
         mode == PlayMode::kCatchFaultRight;
}

Push push_by_angle(const soccer::ServerParams& server, const Player& player, double degrees,
                   double side_rate) {
  const double angle = exact_radians(soccer::between(degrees, server.minmoment, server.maxmoment));
  const double power =
      server.max_back_tackle_power + (server.max_tackle_power - server.max_back_tackle_power) *
                                         (1.0 - std::fabs(angle) / math::kPi);

  return {soccer::polar_radians(power * server.tackle_power_rate * side_rate, angle + player.body),
          1.0};
}

Push push_by_power(const soccer::ServerParams& server, const Player& player, double commanded_power,
                   double side_rate) {
  const double power =
      soccer::between(commanded_power, -server.max_back_tackle_power, server.max_tackle_power);

  double rate = 1.0;
  if (power >= 0.0) {
    rate = power / server.max_tackle_power;
  } else if (server.max_back_tackle_power != 0.0) {
    rate = -power / server.max_back_tackle_power;
  }

  return {soccer::polar_radians(power * server.tackle_power_rate * side_rate, player.body), rate};
}

Push tackle_push(const World& world, const Player& player, double angle_or_power, Vec2 ball) {
  const double side_rate = 1.0 - 0.5 * std::fabs(soccer::direction_radians(ball)) / math::kPi;
  return player.client_version >= kFirstVersionWithAngle
             ? push_by_angle(world.params(), player, angle_or_power, side_rate)
             : push_by_power(world.params(), player, angle_or_power, side_rate);
}

}  // namespace

void tackle(World& world, Player& player, const soccer::Tackle& command, Events& events) {
  if (player.command_done) return;
  const soccer::ServerParams& server = world.params();
  occupy_legs(player);
  player.command_done = true;
  player.tackle_cycles = server.tackle_cycles;
  ++player.counters.tackle;

  const Vec2 ball = ball_relative_to(world, player, player.body);
  const double reach = ball.x > 0.0 ? server.tackle_dist : server.tackle_back_dist;
  if (std::fabs(reach) <= 1e-5) {
    player.state |= state::kTackleFault;
    return;
  }

  const bool foul = command.foul && opponent_has_ball(world, player);
  const double failure = failure_probability(server, ball, reach, foul);
  if (failure >= 1.0) {
    on_ball_missed(world, player.slot(), events);
    player.state |= state::kTackleFault;
    return;
  }

  if (!succeeds(world, player, failure)) {
    on_ball_missed(world, player.slot(), events);
    player.state |= state::kTackle | state::kTackleFault;
    return;
  }

  player.state |= state::kTackle;
  if (!moves_the_ball(world.mode)) return;
  if (foul) player.tackle_cycles = 0;

  Push push = tackle_push(world, player, command.angle_or_power, ball);
  const double noise_rate = 0.5 + 0.5 * (1.0 - failure) + ball_speed_noise_rate(world);
  push.acceleration += ball_noise(
      world, kick_rand(world, player) * server.tackle_rand_factor * push.power_rate * noise_rate,
      world.random.tackle_noise[static_cast<std::size_t>(player.slot())]);

  world.ball_catcher = kNoPlayer;
  world.ball.acceleration += push.acceleration;
  on_tackle_taken(world, player.slot(), push.acceleration.length(), foul, events);
}

}  // namespace cls::simulator::actions
