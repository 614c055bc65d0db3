// Turns a Playmaker's reply into this cycle's commands.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/connection/action_report.h"
#include "proxy/planner/action_context.h"
#include "proxy/planner/action_memory.h"
#include "proxy/world/world_model.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

/// True when the proxy would act by itself before the Playmaker's actions: lying on the ground,
/// before kick-off and after goals, own place or ball unknown. State.need_preprocess.
bool needs_preprocess(const WorldModel& world);

/// One decision: the proxy's own overrides unless the reply forbids them, then the list in order,
/// where the first main action (one that ends in a body command) that succeeds ends the main ones
/// and side actions always run, then queued neck and view defaults (proxy behaviour 2.3, 2.6).
/// Call once per decision on a completed world, with fresh `slots` of that world. Nothing in the
/// reply can fail it: what is unknown or invalid is counted in `report`.
///
/// With `choice` open, a planner action may leave it to the Playmaker: then `choice.chooser` is
/// kWanted, nothing was decided, and execute() is to be called again with the answer in `choice`
/// and with memory, slots and report as they were before. Without one the proxy chooses.
void execute(const protos::PlayerActions& reply, const WorldModel& world, ActionMemory& memory,
             CommandSlots& slots, ActionReport& report, PlanChoice& choice);
void execute(const protos::PlayerActions& reply, const WorldModel& world, ActionMemory& memory,
             CommandSlots& slots, ActionReport& report);

/// The decision without a reply (late, failed or dead Playmaker): what the proxy does by itself
/// (preprocess, view), and looking at the ball.
void execute_without_reply(const WorldModel& world, ActionMemory& memory, CommandSlots& slots,
                           ActionReport& report);

}  // namespace cls::proxy
