// Where each number of the simple team belongs: a 4-3-3 that breathes with the ball.
#pragma once

#include "mock-server/simple_team/situation.h"
#include "soccer/geometry.h"

namespace cls::mock_server {

/// Own place for the present ball, in the own half's view, never offside.
soccer::Vec2 home_position(const Situation& now);

/// Own place in the own half while waiting for a kick-off.
soccer::Vec2 kick_off_position(const Situation& now);

}  // namespace cls::mock_server
