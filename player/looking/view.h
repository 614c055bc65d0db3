// View actions: view width and focus point for the next see message.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Width with a see message every cycle.
bool view_synch(CommandSlots& slots);
/// Width by the distance of play (docs/spec/proxy-behavior.md 2.4).
bool view_tactical(const WorldModel& world, CommandSlots& slots);

/// Moves the focus point to `point`, or as near as its range (40 m) and the view cone allow. Call
/// it after body and neck: the focus direction is relative to the face.
bool focus_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 point);
/// Moves the focus point back to the agent.
bool focus_reset(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::player
