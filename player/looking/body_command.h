// A body command that a policy chose, completed to the commands of a cycle.
#pragma once

#include <vector>

#include "player/world/view_cone.h"
#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::player {

/// Replaces `out` with the body command, clamped and rounded like that of a Playmaker, and the
/// default neck, view and focus (docs/spec/proxy-behavior.md 2.4). `body` is Dash, Turn, Kick,
/// Tackle, Catch or Move; others, and those that the server would reject, become `turn 0`: then the
/// result is false. Call it once per decision, after update_derived().
bool complete_body_command(const WorldModel& world, ViewMemory& view,
                           const soccer::PlayerCommand& body,
                           std::vector<soccer::PlayerCommand>& out, bool with_done);

}  // namespace cls::player
