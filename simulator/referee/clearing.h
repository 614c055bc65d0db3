// Where the referee sends players: onto the field, into their half, away from the ball.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Nobody stays outside pitch and margin.
void keep_players_in_field(World& world);

/// Nobody stands in the other half, and only the side that kicks off in the centre circle (9.3).
void keep_players_in_own_half(World& world);

/// Players of `side` (neutral: all) are put at the distance that the mode asks for (9.4).
void clear_players_from_ball(World& world, Side side, Events& events);

/// The opponents of `side` leave its penalty area for a goal kick.
void clear_penalty_area(World& world, Side side);

}  // namespace cls::simulator
