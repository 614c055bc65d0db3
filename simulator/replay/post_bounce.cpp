// Searches for the direction of motion before a bounce.
#include "simulator/replay/post_bounce.h"

#include <cmath>

#include "simulator/motion/motion.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Vec2;
namespace math = soccer::math;

constexpr double kRounding = 3e-4;  // of the log, added to the reach of noise
constexpr int kDirections = 4000;
constexpr int kRefinements = 6;
constexpr int kFiner = 10;  // divisor of the step per refinement

bool is_near_post(const PostBounce& bounce) {
  const double x = soccer::kHalfLength - soccer::kGoalPostRadius;
  const double y = bounce.goal_width / 2.0 + soccer::kGoalPostRadius;
  const double travel = distance(bounce.from, bounce.expected) + bounce.reach + bounce.radius +
                        soccer::kGoalPostRadius;
  const Vec2 off = {std::fabs(bounce.from.x) - x, std::fabs(bounce.from.y) - y};
  return off.length() <= travel;
}

/// Result of a simulated step in one direction.
struct Trial {
  double direction = 0.0;
  double off = 0.0;  ///< distance from the record
};

class Search {
 public:
  explicit Search(const PostBounce& bounce)
      : bounce_(bounce), speed_(bounce.velocity.length() / bounce.decay) {}

  Vec2 arrival(double direction) const {
    return bounce_.from + soccer::polar_radians(speed_, direction);
  }

  /// Best direction around `middle` that noise can reach and that hits a post.
  std::optional<Trial> best(double middle, double step, int steps) {
    std::optional<Trial> found;
    for (int i = -steps; i <= steps; ++i) {
      const std::optional<Trial> trial = try_direction(middle + step * i);
      if (trial && (!found || trial->off < found->off)) found = trial;
    }
    return found;
  }

 private:
  std::optional<Trial> try_direction(double direction) {
    if (distance(arrival(direction), bounce_.expected) > bounce_.reach + kRounding) return {};
    Vec2 position = bounce_.from;
    Vec2 velocity = soccer::polar_radians(speed_, direction);
    if (!advance_past_posts(position, velocity, bounce_.radius, bounce_.goal_width, stream_)) {
      return {};
    }
    return Trial{direction, distance(position, bounce_.to) +
                                distance(velocity * bounce_.decay, bounce_.velocity)};
  }

  const PostBounce& bounce_;
  double speed_;
  soccer::RandomStream stream_{0, "post bounce"};  // for objects at the center of a post
};

}  // namespace

std::optional<Vec2> arrival_without_post(const PostBounce& bounce) {
  if (bounce.decay == 0.0 || bounce.velocity.is_zero() || !is_near_post(bounce)) return {};
  const Vec2 path = bounce.expected - bounce.from;
  const double length = path.length();
  const double reach = bounce.reach + kRounding;
  // Upper bound of the arc sine.
  const double max_angle = reach >= length ? math::kPi : math::kPi / 2.0 * reach / length;
  Search search(bounce);
  double step = max_angle / kDirections;
  std::optional<Trial> found = search.best(soccer::direction_radians(path), step, kDirections);
  for (int i = 0; i < kRefinements && found; ++i) {
    step /= kFiner;
    const auto finer = search.best(found->direction, step, 2 * kFiner);
    if (finer && finer->off < found->off) found = finer;
  }
  if (!found) return {};
  return search.arrival(found->direction);
}

}  // namespace cls::simulator
