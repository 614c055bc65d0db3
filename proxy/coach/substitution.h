// The built-in choice of player types (proxy behaviour 6.2).
#pragma once

#include <vector>

#include "proxy/coach/coach_notes.h"
#include "proxy/world/world_model.h"
#include "soccer/commands/coach_command.h"

namespace cls::proxy {

/// Appends the changes that are due now: once before the kick-off the goalie gets type 0 and the
/// others the fastest types, forwards and defenders first; in the last 500 cycles of normal time,
/// while play rests, fresh players for those whose recovery has fallen, the weakest first. Never
/// more than the rules allow.
void substitute(const WorldModel& world, CoachNotes& notes, std::vector<soccer::CoachCommand>& out);

}  // namespace cls::proxy
