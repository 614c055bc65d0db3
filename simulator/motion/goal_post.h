// Moving past the goal posts, which everything bounces off without losing speed (3.3).
#pragma once

#include "soccer/geometry.h"
#include "soccer/random.h"

namespace cls::simulator {

/// Adds `velocity` to `position`, and mirrors both at a post that is in the way. Returns whether
/// one was. `stream` is drawn from only if the object lies exactly on the centre of a post.
bool advance_past_posts(soccer::Vec2& position, soccer::Vec2& velocity, double radius,
                        double goal_width, soccer::RandomStream& stream);

}  // namespace cls::simulator
