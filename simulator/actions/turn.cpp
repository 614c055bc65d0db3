// turn: how far depends on the speed (4.2).
#include <algorithm>
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/motion.h"

namespace cls::simulator::actions {

namespace math = soccer::math;

void turn(World& world, Player& player, const soccer::Turn& command) {
  if (player.command_done) return;
  const soccer::ServerParams& server = world.params();
  const double moment =
      math::to_radians(std::clamp(command.moment, server.minmoment, server.maxmoment));
  const double rand = player_rand(world, player);
  RandomStream& stream = world.random.turn[static_cast<std::size_t>(player.slot())];
  const double noise = 1.0 + stream.uniform(-rand, rand);
  const double inertia = 1.0 + world.type_of(player).inertia_moment * player.velocity.length();
  player.pending_body = math::normalize_radians(player.body + noise * moment / inertia);
  occupy_legs(player);
  player.command_done = true;
  ++player.counters.turn;
}

}  // namespace cls::simulator::actions
