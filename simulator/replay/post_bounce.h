// Reconstructs the noise of an object that bounced off a goal post.
#pragma once

#include <optional>

#include "soccer/geometry.h"

namespace cls::simulator {

/// Recorded step of one object.
struct PostBounce {
  soccer::Vec2 from;
  soccer::Vec2 expected;  ///< arrival without noise and without the post
  double reach = 0.0;     ///< maximum distance from `expected` by noise
  double radius = 0.0;    ///< of the object
  double decay = 1.0;
  soccer::Vec2 to;        ///< recorded
  soccer::Vec2 velocity;  ///< recorded, after decay
  double goal_width = 0.0;
};

/// Returns where noise would have moved the object without the post: the position within reach
/// whose bounce is closest to the record. Returns no value if no path within reach hits a post. A
/// bounce keeps the speed, so only the direction is unknown; recorded position and direction verify
/// it.
std::optional<soccer::Vec2> arrival_without_post(const PostBounce& bounce);

}  // namespace cls::simulator
