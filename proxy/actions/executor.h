// Executes a Playmaker's reply as this cycle's commands.
#pragma once

#include <functional>

#include "player/commands/command_slots.h"
#include "player/planner/action_context.h"
#include "player/world/world_model.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

/// One decision: automatic actions unless the reply disables them, then the list in sequence, then
/// queued neck and view defaults (docs/spec/proxy-behavior.md 2.3, 2.6). The first main action (one
/// that ends in a body command) that succeeds ends the main actions; side actions always run. Call
/// once per decision on a completed world, with fresh `slots` of that world. Unknown and invalid
/// actions are counted in `report`.
///
/// With `choice` open, a planner action may request the Playmaker's choice: `choice.chooser` is
/// then kRequested and nothing is decided. Call execute() again with the reply in `choice` and with
/// memory, slots and report as before. Without `choice` the proxy chooses.
void execute(const protos::PlayerActions& reply, const player::WorldModel& world,
             player::ActionMemory& memory, player::CommandSlots& slots,
             player::ActionReport& report, player::PlanChoice& choice);
void execute(const protos::PlayerActions& reply, const player::WorldModel& world,
             player::ActionMemory& memory, player::CommandSlots& slots,
             player::ActionReport& report);

/// What a player does instead of a list, automatic play included: between begin_decision() and
/// finish_decision().
using OwnPlay = std::function<void(player::ActionContext& context)>;

/// One decision by it, with fresh `slots` and `choice`, in which it may leave what it considered.
void execute_own_play(const OwnPlay& play, const player::WorldModel& world,
                      player::ActionMemory& memory, player::CommandSlots& slots,
                      player::ActionReport& report, player::PlanChoice& choice);

/// Automatic play for missed decisions (OnLate::kDefault). Replaces `out`: clear the ball,
/// intercept it when first, otherwise move to the home position; look at the ball.
void choose_fallback_actions(const player::WorldModel& world, protos::PlayerActions& out);

/// The decision without a reply (deadline exceeded or failed call): automatic actions (preprocess,
/// view), and looking at the ball.
void execute_without_reply(const player::WorldModel& world, player::ActionMemory& memory,
                           player::CommandSlots& slots, player::ActionReport& report);

}  // namespace cls::proxy
