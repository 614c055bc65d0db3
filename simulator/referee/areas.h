// Areas and lines of the pitch used by the rules (docs/spec/simulation-model.md 9.2).
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

Vec2 clamp_to_pitch(Vec2 point);

// Moves a point inside the area that `side` defends (neutral: either side) out of it: from the
// penalty area to its corner, from the goal area to its front line. Other points stay unchanged.
Vec2 move_out_of_penalty_area(Side side, Vec2 point);
Vec2 move_out_of_goal_area(Side side, Vec2 point);

/// True inside the penalty area of `side` (neutral: either), enlarged by the ball radius.
bool in_penalty_area(Side side, Vec2 point);

/// True inside the goal area that `side` defends.
bool in_goal_area(Side side, Vec2 point);

/// |x| beyond which the whole ball is over the goal line.
double goal_line(const World& world);

/// True if the ball moved from `before` straight through the goal that `defender` defends, wholly
/// over the line.
bool crossed_goal_line(const World& world, Side defender, Vec2 before);

}  // namespace cls::simulator
