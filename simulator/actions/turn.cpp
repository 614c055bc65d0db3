// turn: the angle depends on the speed (docs/spec/simulation-model.md 4.2).
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/motion/motion.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator::actions {

namespace math = soccer::math;

namespace {

// Executed share of the turn. During log replay: the recorded share, if noise can explain it.
double executed_share(World& world, const Player& player, double planned) {
  const double rand = player_rand(world, player);
  const auto slot = static_cast<std::size_t>(player.slot());
  const double drawn = 1.0 + world.random.turn[slot].uniform(-rand, rand);
  if (!world.overrides || !world.overrides->body[slot]) return drawn;
  const double rounding = exact_radians(0.1);  // effect of the rounded speed on the inertia
  const double noise =
      math::normalize_radians(*world.overrides->body[slot] - (player.body + planned));
  const bool explained = rand > 0.0 && std::fabs(noise) <= rand * std::fabs(planned) + rounding;
  return explained && planned != 0.0 ? 1.0 + noise / planned : 1.0;
}

}  // namespace

void turn(World& world, Player& player, const soccer::Turn& command) {
  if (player.command_done) return;
  const soccer::ServerParams& server = world.params();
  const double moment =
      exact_radians(soccer::between(command.moment, server.minmoment, server.maxmoment));
  const double inertia = 1.0 + world.type_of(player).inertia_moment * player.velocity.length();
  const double share = executed_share(world, player, moment / inertia);
  player.pending_body = math::normalize_radians(player.body + share * moment / inertia);
  occupy_legs(player);
  player.command_done = true;
  ++player.counters.turn;
}

}  // namespace cls::simulator::actions
