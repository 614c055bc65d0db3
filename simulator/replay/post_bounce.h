// Which noise led an object to where it bounced off a goal post.
#pragma once

#include <optional>

#include "soccer/geometry.h"

namespace cls::simulator {

/// One object's recorded step.
struct PostBounce {
  soccer::Vec2 from;
  soccer::Vec2 expected;  ///< where it would come without noise if there were no post
  double reach = 0.0;     ///< how far from there noise can take it
  double radius = 0.0;    ///< of the object
  double decay = 1.0;
  soccer::Vec2 to;        ///< recorded
  soccer::Vec2 velocity;  ///< recorded, after decay
  double goal_width = 0.0;
};

/// Where noise would have taken the object if there were no post: the place within reach whose
/// bounce comes nearest to the record. Nothing if no way within reach meets a post. A bounce keeps
/// the speed, so the recorded one leaves only the direction to be found; position and direction of
/// the bounce, three more numbers, tell whether it is the right one.
std::optional<soccer::Vec2> arrival_without_post(const PostBounce& bounce);

}  // namespace cls::simulator
