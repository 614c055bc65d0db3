// World model of coaches and trainers, from exact views of the whole field.
#pragma once

#include "player/world/world_model.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/side.h"

namespace cls::proxy {

// Sequence in a cycle: hear messages, the view, complete_global(), the decision.

/// Side and name of the own team. For a trainer (side neutral) it is the left team, whose name
/// arrives later.
void on_coach_init(player::WorldModel& world, soccer::Side side, soccer::TeamName team_name);

/// Begins a new cycle or stopped cycle with the exact positions of the view. Teammates are players
/// with the own team name; coordinates are rotated so that the own team attacks +x.
void on_global_view(player::WorldModel& world, const soccer::GlobalView& view);

/// Handles referee messages; other messages are ignored.
void on_coach_hear(player::WorldModel& world, const soccer::Hear& hear);

/// Derives last kick, kickable flags, intercept table and lines. Once per decision.
void complete_global(player::WorldModel& world);

}  // namespace cls::proxy
