// Width of view and focus point: how the eyes are set for the next see message.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// The width that brings a see message every cycle.
bool view_synch(CommandSlots& slots);
/// The width that suits the distance of play (proxy behaviour 2.4).
bool view_tactical(const WorldModel& world, CommandSlots& slots);

/// Sharpest sight at the point, or as near to it as reach (40 m) and view allow. Call it after body
/// and neck are chosen: the focus moves with the face.
bool focus_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 point);
/// Focus back to the agent itself.
bool focus_reset(const WorldModel& world, CommandSlots& slots);

}  // namespace cls::proxy
