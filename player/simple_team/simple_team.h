// The bundled team, and a team that only holds its positions.
#pragma once

#include "player/simple_team/action_list.h"
#include "player/simple_team/situation.h"

namespace cls::player {

/// A 4-3-3 that passes, dribbles, shoots and defends well enough for an ordinary match against
/// itself. Appends the actions of one player for one cycle to the empty list.
void play_simple_team(const Situation& now, ActionList& list);

/// Moves to the kick-off positions, then only turns to the ball: a baseline opponent.
void hold_positions(const Situation& now, ActionList& list);

}  // namespace cls::player
