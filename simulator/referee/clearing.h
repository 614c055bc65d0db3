// Positions enforced by the referee: in the field, in the own half, away from the ball.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Moves players that are beyond the pitch margin back to it.
void keep_players_in_field(World& world);

/// Moves players out of the opponent half, and all but the side that kicks off out of the center
/// circle (docs/spec/simulation-model.md 9.3).
void keep_players_in_own_half(World& world);

/// Moves players of `side` (neutral: all) to the distance from the ball that the mode requires
/// (docs/spec/simulation-model.md 9.4).
void clear_players_from_ball(World& world, Side side, Events& events);

/// Moves the opponents of `side` out of its penalty area before a goal kick.
void clear_penalty_area(World& world, Side side);

}  // namespace cls::simulator
