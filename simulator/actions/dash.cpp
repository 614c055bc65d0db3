// dash: stored per leg when received, applied in the step (docs/spec/simulation-model.md 4.3).
#include <algorithm>
#include <cmath>

#include "simulator/actions/actions.h"
#include "simulator/actions/commands.h"
#include "simulator/motion/motion.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

double leg_cost(const Leg& leg) {
  if (!leg.dashes) return 0.0;
  return leg.power >= 0.0 ? leg.power / 2.0 : -leg.power;
}

// Share of the power that is effective in this direction; 1 straight ahead.
double direction_rate(const soccer::ServerParams& server, double direction) {
  const double off = std::fabs(direction);
  const double side = server.side_dash_rate;
  const double back = server.back_dash_rate;
  const double rate = off <= 90.0 ? side + (1.0 - side) * (1.0 - off / 90.0)
                                  : back - (back - side) * (1.0 - (off - 90.0) / 90.0);
  return std::clamp(rate, 0.0, 1.0);
}

Vec2 leg_acceleration(const World& world, const Player& player, const Leg& leg, double cost) {
  if (!leg.dashes) return {};
  const soccer::ServerParams& server = world.params();
  const double power = soccer::between(leg.power >= 0.0 ? cost * 2.0 : -cost, server.min_dash_power,
                                       server.max_dash_power);
  const double length =
      std::fabs(player.stamina.effort * power * direction_rate(server, leg.direction) *
                world.type_of(player).dash_power_rate) /
      slowness_on_top(world, player);
  const double direction = math::normalize_radians(player.body + exact_radians(leg.direction));
  const Vec2 push = soccer::polar_radians(length, direction);
  return power < 0.0 ? -push : push;
}

// rcssserver checks the left leg only: with the right leg alone the player does not rotate
// (docs/spec/simulation-model.md 15.1).
void rotate(World& world, Player& player, Vec2 left, Vec2 right) {
  if (!player.legs[0].dashes) return;
  const Vec2 forward = soccer::polar_radians(1.0, player.body);
  const double turned = dot(forward, left - right) / (2.0 * world.type_of(player).player_size);
  const double rand = player_rand(world, player);
  RandomStream& stream = world.random.turn[static_cast<std::size_t>(player.slot())];
  const double noise = 1.0 + stream.uniform(-rand, rand);
  player.pending_body = math::normalize_radians(player.body + noise * turned);
}

void command_leg(const soccer::ServerParams& server, Leg& leg, const soccer::Dash& command) {
  const double power = soccer::between(command.power, server.min_dash_power, server.max_dash_power);
  const double direction =
      soccer::between(command.direction, server.min_dash_angle, server.max_dash_angle);
  leg = {true, true, power, math::quantize(direction, server.dash_angle_step)};
}

}  // namespace

void apply_dash(World& world, Player& player) {
  const auto& [left, right] = player.legs;
  if (!left.dashes && !right.dashes) return;
  ++player.counters.dash;
  const double left_cost = leg_cost(left);
  const double right_cost = leg_cost(right);
  const double wanted = left_cost + right_cost;
  if (wanted < 1e-5) return;

  Stamina& stamina = player.stamina;
  const double spent = std::min(wanted, stamina.value + world.type_of(player).extra_stamina);
  // The right leg's share uses the reduced cost of the left leg, so the legs differ when stamina is
  // short (docs/spec/simulation-model.md 15.1).
  const double left_share = spent * left_cost / wanted;
  const double right_share = spent * right_cost / (left_share + right_cost);
  const Vec2 left_push = leg_acceleration(world, player, left, left_share);
  const Vec2 right_push = leg_acceleration(world, player, right, right_share);
  player.acceleration += (left_push + right_push) / 2.0;
  rotate(world, player, left_push, right_push);
  stamina.value = std::max(0.0, stamina.value - spent);
}

namespace actions {

void dash(World& world, Player& player, const soccer::Dash& command) {
  if (player.command_done) return;
  for (Leg& leg : player.legs) {
    if (!leg.commanded) command_leg(world.params(), leg, command);
  }
  player.dash_cycles = 1;
  player.command_done = true;
}

void dash(World& world, Player& player, const soccer::LegDash& command) {
  const std::array<const std::optional<soccer::Dash>*, 2> commands = {&command.left,
                                                                      &command.right};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!commands[i]->has_value() || player.legs[i].commanded) continue;
    command_leg(world.params(), player.legs[i], **commands[i]);
    player.dash_cycles = 1;
    player.command_done = true;
  }
}

}  // namespace actions
}  // namespace cls::simulator
