// Bouncing off goal posts: an object counts as a point, the post as a circle of both radii.
#include "simulator/motion/goal_post.h"

#include <array>
#include <cmath>
#include <optional>

#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Vec2;
namespace math = soccer::math;

// More bounces than this in one cycle need four posts in a heap.
constexpr int kMaxBounces = 100;

struct Posts {
  double x;
  double y;
  double reach;  ///< radius of the obstacle

  // The signs alone choose.
  Vec2 relevant_for(Vec2 p) const { return {p.x > 0.0 ? x : -x, p.y > 0.0 ? y : -y}; }

  bool can_meet(Vec2 p, double travel) const {
    const double margin = reach + travel;
    return std::fabs(std::fabs(p.x) - x) <= margin && std::fabs(std::fabs(p.y) - y) <= margin;
  }
};

Vec2 mirrored_along(Vec2 v, Vec2 axis) {
  const double length2 = axis.squared_length();
  if (length2 == 0.0) return v;
  return v - axis * (2.0 * dot(v, axis) / length2);
}

bool push_out(const Posts& posts, Vec2& position, Vec2& velocity, soccer::RandomStream& stream) {
  bool hit = false;
  Vec2 post = posts.relevant_for(position);
  while (distance(position, post) < posts.reach) {
    hit = true;
    Vec2 away = position - post;
    away = away.is_zero()
               ? soccer::polar_radians(posts.reach, stream.uniform(-math::kPi, math::kPi))
               : soccer::with_length(away, posts.reach);
    position = post + away;
    while (distance(position, post) < posts.reach) {
      away *= 1.01;
      position = post + away;
    }
    velocity = mirrored_along(velocity, post - position);
    post = posts.relevant_for(position);
  }
  return hit;
}

// Where the way from `from` to `to` first meets the circle.
std::optional<Vec2> meeting_point(Vec2 from, Vec2 to, Vec2 centre, double radius) {
  const Vec2 way = to - from;
  const double length2 = way.squared_length();
  if (length2 == 0.0) return std::nullopt;
  const Vec2 start = from - centre;
  if (std::sqrt(length2) < start.length() - radius) return std::nullopt;
  const double area = cross(start, to - centre);
  const double discriminant = radius * radius * length2 - area * area;
  if (discriminant <= 0.0) return std::nullopt;

  const double middle = -dot(start, way) / length2;
  const double half = std::sqrt(discriminant) / length2;
  const double first = middle - half;
  const double second = middle + half;
  const auto on_the_way = [](double t) { return t >= 0.0 && t <= 1.0; };
  if (on_the_way(first)) {
    // Leaving the circle along its tangent is no meeting.
    if (first == 0.0 && !on_the_way(second)) return std::nullopt;
    return from + way * first;
  }
  if (on_the_way(second) && second != 0.0) return from + way * second;
  return std::nullopt;
}

}  // namespace

bool advance_past_posts(Vec2& position, Vec2& velocity, double radius, double goal_width,
                        soccer::RandomStream& stream) {
  const Posts posts{soccer::kHalfLength - soccer::kGoalPostRadius,
                    goal_width / 2.0 + soccer::kGoalPostRadius, soccer::kGoalPostRadius + radius};
  const double speed = velocity.length();
  if (!posts.can_meet(position, speed)) {
    position += velocity;
    return false;
  }
  bool hit = push_out(posts, position, velocity, stream);

  Vec2 target = position + velocity;
  for (int bounce = 0; bounce < kMaxBounces && !(position == target); ++bounce) {
    Vec2 post = posts.relevant_for(position);
    std::optional<Vec2> met = meeting_point(position, target, post, posts.reach);
    if (const Vec2 other = posts.relevant_for(target); !met && !(other == post)) {
      post = other;
      met = meeting_point(position, target, post, posts.reach);
    }
    if (!met) break;
    hit = true;
    const Vec2 rest = mirrored_along(target - *met, post - *met);
    // A hair's breadth off, so that the next look does not find the same meeting.
    position = *met + soccer::with_length(*met - post, math::kEps);
    target = position + rest;
    velocity = soccer::polar_radians(speed, soccer::direction_radians(rest));
  }
  position = target;
  return hit;
}

}  // namespace cls::simulator
