// Has the ball gone into a goal?
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// True if the ball went from `before` to where it is straight through the goal that `defender`
/// defends, wholly over the line.
bool crossed_goal_line(const World& world, Side defender, Vec2 before);

}  // namespace cls::simulator
