// Puts the body command into its slot, then looks.
#include "player/looking/looking.h"

#include "base/overloaded.h"
#include "player/commands/command_slots.h"
#include "player/world/motion.h"

namespace cls::player {
namespace {

bool set_body(const WorldModel& world, const soccer::PlayerCommand& body, CommandSlots& slots) {
  return std::visit(
      base::Overloaded{
          [&](const soccer::Dash& dash) { return slots.dash(dash.power, dash.direction); },
          [&](const soccer::LegDash& legs) { return slots.dash(legs); },
          // The slot takes the angle that the body turns by; the command has the moment.
          [&](const soccer::Turn& turn) {
            return slots.turn(turn.moment /
                              turn_resistance(world.self_type(), world.self.velocity));
          },
          [&](const soccer::Kick& kick) { return slots.kick(kick.power, kick.direction); },
          [&](const soccer::Tackle& tackle) {
            return slots.tackle(tackle.angle_or_power, tackle.foul);
          },
          [&](const soccer::Catch&) { return slots.catch_ball(); },
          [&](const soccer::Move& move) {
            return slots.move({move.x, move.y});
          },
          [](const auto&) { return false; },
      },
      body);
}

}  // namespace

bool complete_body_command(const WorldModel& world, ViewMemory& view,
                           const soccer::PlayerCommand& body,
                           std::vector<soccer::PlayerCommand>& out, bool with_done) {
  update_view_memory(view, world);
  CommandSlots slots(world);
  const bool accepted = set_body(world, body, slots);

  // The order of the executor for a list of the body action and Neck_TurnToBallOrScan.
  neck_turn_to_ball_or_scan(world, view, slots, 0);
  view_tactical(world, slots);
  if (world.ball.position_valid()) focus_to_point(world, slots, ball_after(world, 1));

  slots.compose(out, with_done);
  return accepted;
}

}  // namespace cls::player
