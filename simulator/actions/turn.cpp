// turn, turn_neck, change_focus, change_view (docs/spec/simulation-model.md 4.2, 4.9 to 4.11).
#include <algorithm>
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/motion/motion.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator::actions {

namespace math = soccer::math;

namespace {

// Executed share of a turn, which depends on the speed. During log replay: the recorded share, if
// noise can explain it.
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

constexpr double kMaxFocusDistance = 40.0;

double clamp_to_view(const World& world, const View& view, double direction) {
  const double half = view_cone(view, world.params().visible_angle) / 2.0;
  return soccer::between(direction, -half, half);
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

void turn_neck(World& world, Player& player, const soccer::TurnNeck& command) {
  if (player.turn_neck_done) return;
  const soccer::ServerParams& server = world.params();
  const double moment = soccer::between(command.moment, server.minneckmoment, server.maxneckmoment);
  player.pending_neck =
      soccer::between(player.neck + exact_radians(moment), exact_radians(server.minneckang),
                      exact_radians(server.maxneckang));
  player.turn_neck_done = true;
  ++player.counters.turn_neck;
}

void change_focus(World& world, Player& player, const soccer::ChangeFocus& command) {
  View& view = player.view;
  view.focus_distance =
      std::clamp(view.focus_distance + command.moment_distance, 0.0, kMaxFocusDistance);
  const double direction =
      math::normalize_radians(view.focus_direction + exact_radians(command.moment_direction));
  view.focus_direction = clamp_to_view(world, view, direction);
  ++player.counters.change_focus;
}

void change_view(World& world, Player& player, const soccer::ChangeView& command) {
  View& view = player.view;
  if (view.synchronous && command.quality == soccer::ViewQuality::kLow) return;
  view.width = command.width;
  view.quality = command.quality.value_or(soccer::ViewQuality::kHigh);
  // Only the form without a quality clamps the focus to the new view cone
  // (docs/spec/simulation-model.md 15.2).
  if (!command.quality) {
    view.focus_direction = clamp_to_view(world, view, view.focus_direction);
  }
  ++player.counters.change_view;
}

}  // namespace cls::simulator::actions
