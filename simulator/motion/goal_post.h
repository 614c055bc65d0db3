// Motion with elastic bounces off goal posts (docs/spec/simulation-model.md 3.3).
#pragma once

#include "soccer/geometry.h"
#include "soccer/random.h"

namespace cls::simulator {

/// Adds `velocity` to `position` and reflects both at posts in the path. Returns true after a
/// bounce. Draws from `stream` only if the object is exactly at the center of a post.
bool advance_past_posts(soccer::Vec2& position, soccer::Vec2& velocity, double radius,
                        double goal_width, soccer::RandomStream& stream);

}  // namespace cls::simulator
