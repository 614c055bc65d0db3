// What coaches and trainers are told, taken into a world model: everything, without noise.
#pragma once

#include "proxy/world/world_model.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/side.h"

namespace cls::proxy {

// Order within a cycle: hear messages, the view, complete_global(), the decision.

/// Side and name of the own team. A trainer (side neutral) has none: its team is the left one,
/// whose name is learnt later.
void on_coach_init(WorldModel& world, soccer::Side side, soccer::TeamName team_name);

/// Opens a new moment: everything is where the view says, seen now. Players are ours by the name of
/// their team, turned so that we attack +x.
void on_global_view(WorldModel& world, const soccer::GlobalView& view);

/// The referee's words; what others say is not kept.
void on_coach_hear(WorldModel& world, const soccer::Hear& hear);

/// Derives last kick, kickable flags, ways to the ball and lines. Call it once per decision.
void complete_global(WorldModel& world);

}  // namespace cls::proxy
