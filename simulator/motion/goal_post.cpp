// Bounces off goal posts: the object is a point, the post a circle with the sum of both radii.
#include "simulator/motion/goal_post.h"

#include <array>
#include <cmath>
#include <optional>

#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Vec2;
namespace math = soccer::math;

constexpr int kMaxBounces = 100;

struct Posts {
  double x;
  double y;
  double reach;  ///< radius of the obstacle

  Vec2 nearest_to(Vec2 p) const { return {p.x > 0.0 ? x : -x, p.y > 0.0 ? y : -y}; }

  bool can_reach(Vec2 p, double travel) const {
    const double margin = reach + travel;
    return std::fabs(std::fabs(p.x) - x) <= margin && std::fabs(std::fabs(p.y) - y) <= margin;
  }
};

Vec2 reflect(Vec2 v, Vec2 axis) {
  const double length2 = axis.squared_length();
  if (length2 == 0.0) return v;
  return v - axis * (2.0 * dot(v, axis) / length2);
}

bool push_out(const Posts& posts, Vec2& position, Vec2& velocity, soccer::RandomStream& stream) {
  bool hit = false;
  Vec2 post = posts.nearest_to(position);
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

    velocity = reflect(velocity, post - position);
    post = posts.nearest_to(position);
  }
  return hit;
}

// First intersection of the segment from `from` to `to` with the circle.
std::optional<Vec2> first_intersection(Vec2 from, Vec2 to, Vec2 center, double radius) {
  const Vec2 path = to - from;
  const double length2 = path.squared_length();
  if (length2 == 0.0) return std::nullopt;

  const Vec2 start = from - center;
  if (std::sqrt(length2) < start.length() - radius) return std::nullopt;

  const double area = cross(start, to - center);
  const double discriminant = radius * radius * length2 - area * area;
  if (discriminant <= 0.0) return std::nullopt;

  const double middle = -dot(start, path) / length2;
  const double half = std::sqrt(discriminant) / length2;
  const double first = middle - half;
  const double second = middle + half;
  const auto on_segment = [](double t) { return t >= 0.0 && t <= 1.0; };
  if (on_segment(first)) {
    // Leaving the circle along its tangent is not a contact.
    if (first == 0.0 && !on_segment(second)) return std::nullopt;
    return from + path * first;
  }

  if (on_segment(second) && second != 0.0) return from + path * second;
  return std::nullopt;
}

}  // namespace

bool advance_past_posts(Vec2& position, Vec2& velocity, double radius, double goal_width,
                        soccer::RandomStream& stream) {
  const Posts posts{soccer::kHalfLength - soccer::kGoalPostRadius,
                    goal_width / 2.0 + soccer::kGoalPostRadius, soccer::kGoalPostRadius + radius};

  const double speed = velocity.length();
  if (!posts.can_reach(position, speed)) {
    position += velocity;
    return false;
  }
  bool hit = push_out(posts, position, velocity, stream);

  Vec2 target = position + velocity;
  for (int bounce = 0; bounce < kMaxBounces && !(position == target); ++bounce) {
    Vec2 post = posts.nearest_to(position);
    std::optional<Vec2> contact = first_intersection(position, target, post, posts.reach);
    if (const Vec2 other = posts.nearest_to(target); !contact && !(other == post)) {
      post = other;
      contact = first_intersection(position, target, post, posts.reach);
    }
    if (!contact) break;

    hit = true;
    const Vec2 rest = reflect(target - *contact, post - *contact);
    // Slightly outside the circle, so that the next iteration does not find the same contact.
    position = *contact + soccer::with_length(*contact - post, math::kEps);
    target = position + rest;
    velocity = soccer::polar_radians(speed, soccer::direction_radians(rest));
  }

  position = target;
  return hit;
}

}  // namespace cls::simulator
