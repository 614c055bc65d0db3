// Effect of two-leg dashes, and the search for the one that turns the body.
#include "player/world/leg_dash.h"

#include <algorithm>
#include <cmath>

#include "player/world/motion.h"
#include "soccer/commands/rounding.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

using soccer::Dash;
using soccer::LegDash;
using soccer::ServerParams;

double leg_cost(const Dash& leg) { return leg.power >= 0.0 ? leg.power / 2.0 : -leg.power; }

Dash executed_leg(const ServerParams& server, const std::optional<Dash>& leg) {
  if (!leg) return {};
  const double direction =
      soccer::between(leg->direction, server.min_dash_angle, server.max_dash_angle);
  return {soccer::between(leg->power, server.min_dash_power, server.max_dash_power),
          math::quantize(direction, server.dash_angle_step)};
}

/// Acceleration of a leg that spends `cost`, with effort 1 and dash power rate 1, body along +x.
Vec2 push(const ServerParams& server, const Dash& leg, double cost) {
  const double power = soccer::between(leg.power >= 0.0 ? cost * 2.0 : -cost, server.min_dash_power,
                                       server.max_dash_power);
  return soccer::polar_degrees(power * dash_rate(server, leg.direction), leg.direction);
}

struct InnerLeg {
  double power = 0.0;
  std::size_t direction = 0;  ///< index of LegPushes
  double progress = -1.0;     ///< of both legs; less is not sought
  bool found = false;
};

/// The inner leg that brings the turn to `difference` (of the forward pushes of both legs, in units
/// of power) with an outer leg of `outer` straight ahead, and gains most along `heading`.
InnerLeg inner_leg(const MatchParameters& parameters, double outer, double difference, Vec2 heading,
                   double power) {
  const ServerParams& server = parameters.server;
  const LegPushes& pushes = parameters.leg_pushes;
  const double forward = outer - difference;
  const double max_inner = std::min(server.max_dash_power, 2.0 * power - outer);
  const double step = server.dash_angle_step;
  const bool any_direction =
      step <= 1.0 || std::fabs(std::remainder(LegPushes::kStep, step)) < math::kEps;

  InnerLeg best;
  best.progress = -outer;
  for (std::size_t i = 0; i < LegPushes::kCount; i += any_direction ? 1 : LegPushes::kCount - 1) {
    const double needed = forward * pushes.per_forward[i];
    if (!(needed >= 0.0 && needed <= max_inner) || pushes.per_forward[i] == 0.0) continue;
    const double progress =
        0.5 * (outer * heading.x + needed * soccer::dot(pushes.push[i], heading));
    if (progress > best.progress) best = {needed, i, progress, true};
  }
  return best;
}

constexpr double kNothing = 1e-9;

}  // namespace

DashEffect leg_dash_effect(const WorldModel& world, AngleDeg body, const LegDash& legs) {
  const ServerParams& server = world.server();
  const soccer::PlayerType& type = world.self_type();
  const Dash left = executed_leg(server, legs.left);
  const Dash right = executed_leg(server, legs.right);
  const double left_cost = leg_cost(left);
  const double right_cost = leg_cost(right);
  const double wanted = left_cost + right_cost;

  DashEffect effect;
  if (wanted < 1e-5) return effect;
  effect.cost = std::min(wanted, world.self.stamina + type.extra_stamina);

  const double left_share = effect.cost * left_cost / wanted;
  // With the reduced share of the left leg, as in the server.
  const double right_share =
      right_cost > 0.0 ? effect.cost * right_cost / (left_share + right_cost) : 0.0;
  const double strength = world.self.effort * type.dash_power_rate;
  const Vec2 left_push = push(server, left, left_share) * strength;
  const Vec2 right_push = push(server, right, right_share) * strength;

  effect.acceleration =
      speed_limited(soccer::rotated_degrees((left_push + right_push) / 2.0, body.degrees()),
                    server.player_accel_max);
  // The server turns the body only if the left leg has a dash.
  const double turn = math::to_degrees((left_push.x - right_push.x) / (2.0 * type.player_size));
  if (legs.left && std::isfinite(turn)) effect.turn = turn;
  return effect;
}

std::optional<LegTurn> leg_turn(const WorldModel& world, double angle, double power) {
  const ServerParams& server = world.server();
  const soccer::PlayerType& type = world.self_type();
  const double strength = world.self.effort * type.dash_power_rate;
  if (!(strength > kNothing)) return std::nullopt;

  const double turn = std::fabs(angle);
  const Vec2 heading = soccer::polar_degrees(1.0, turn);
  const double difference = math::to_radians(turn) * 2.0 * type.player_size / strength;

  for (const double share : {1.0, 0.8, 0.6, 0.4}) {
    const double outer = share * server.max_dash_power;
    if (outer > 2.0 * power) continue;
    const InnerLeg inner = inner_leg(*world.parameters, outer, difference, heading, power);
    if (!inner.found) continue;

    const double side = angle < 0.0 ? -1.0 : 1.0;
    const double direction = static_cast<double>(inner.direction) * LegPushes::kStep;
    const Dash outer_dash{outer, 0.0};
    const Dash inner_dash{soccer::rounded_for_command(inner.power), side * direction};
    const Vec2 inner_push = world.parameters->leg_pushes.push[inner.direction] * inner.power;
    const Vec2 push = Vec2{outer + inner_push.x, side * inner_push.y} * (0.5 * strength);

    LegTurn out;
    out.legs = angle < 0.0 ? LegDash{inner_dash, outer_dash} : LegDash{outer_dash, inner_dash};
    out.acceleration = speed_limited(soccer::rotated_degrees(push, world.self.body.degrees()),
                                     server.player_accel_max);
    out.cost = 0.5 * (outer + inner.power);
    out.progress = inner.progress * strength;
    out.efficiency = inner.progress / out.cost;
    return out;
  }
  return std::nullopt;
}

std::optional<LegTurn> useful_leg_turn(const WorldModel& world, double angle, double power,
                                       bool hurry) {
  if (!world.leg_dashes) return std::nullopt;
  constexpr double kMinTurn = 1.0;  // below, the body points there
  if (std::fabs(angle) < kMinTurn) return std::nullopt;

  const std::optional<LegTurn> turn = leg_turn(world, angle, power);
  if (!turn) return std::nullopt;
  constexpr double kEfficient = 0.6;
  constexpr double kInAHurry = 0.25;
  const bool gains = turn->efficiency >= (hurry ? kInAHurry : kEfficient);
  const bool only_way = hurry && turn->progress > 0.0 && std::fabs(angle) > max_turn(world);
  return gains || only_way ? turn : std::nullopt;
}

}  // namespace cls::player
