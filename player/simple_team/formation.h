// Home positions of the simple team: a 4-3-3 that shifts with the ball.
#pragma once

#include "player/simple_team/situation.h"
#include "soccer/geometry.h"

namespace cls::player {

/// Home position for the current ball; never offside. The team attacks +x.
soccer::Vec2 home_position(const Situation& now);

/// Position in the own half before a kick-off.
soccer::Vec2 kick_off_position(const Situation& now);

}  // namespace cls::player
