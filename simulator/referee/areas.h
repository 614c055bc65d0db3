// Parts of the pitch that the rules speak of, and how a point is moved out of them (9.2).
#pragma once

#include "simulator/world/player.h"

namespace cls::simulator {

/// The point clamped to the pitch.
Vec2 truncated(Vec2 point);

// A point inside the area that `side` defends (neutral: either side's) is moved out of it: from the
// penalty area to its corner, from the goal area to its front line. Others stay.
Vec2 out_of_penalty_area(Side side, Vec2 point);
Vec2 out_of_goal_area(Side side, Vec2 point);

/// True inside the penalty area of `side` (neutral: either), grown by the radius of the ball.
bool in_penalty_area(Side side, Vec2 point);

/// True in the goal area that `side` defends.
bool in_goal_area(Side side, Vec2 point);

}  // namespace cls::simulator
