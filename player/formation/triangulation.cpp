// Bowyer-Watson: inserts points one by one and replaces the triangles whose circumcircle contains
// the point by a fan.
#include "player/formation/triangulation.h"

#include <algorithm>
#include <utility>

namespace cls::player {
namespace {

double doubled_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// Positive when `p` lies inside the circle through the corners of a counterclockwise triangle.
double in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  const Vec2 u = a - p;
  const Vec2 v = b - p;
  const Vec2 w = c - p;
  return u.squared_length() * cross(v, w) - v.squared_length() * cross(u, w) +
         w.squared_length() * cross(u, v);
}

}  // namespace

std::vector<Edge> boundary(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge{t[i], t[(i + 1) % 3]};
      const auto twin = std::ranges::find(edges, Edge{edge.second, edge.first});
      if (twin == edges.end()) {
        edges.push_back(edge);
      } else {
        edges.erase(twin);
      }
    }
  }

  return edges;
}

std::vector<Triangle> triangulate(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  if (count < 3) return {};

  // Super-triangle around all points, far enough to act as infinity.
  constexpr double kFar = 1e5;
  std::vector<Vec2> all = points;
  all.insert(all.end(), {{-3.0 * kFar, -kFar}, {3.0 * kFar, -kFar}, {0.0, 3.0 * kFar}});
  std::vector<Triangle> triangles{{count, count + 1, count + 2}};

  for (std::size_t p = 0; p < count; ++p) {
    const auto affected =
        std::partition(triangles.begin(), triangles.end(), [&](const Triangle& t) {
          return in_circle(all[t[0]], all[t[1]], all[t[2]], all[p]) <= 0.0;
        });

    const std::vector<Triangle> broken(affected, triangles.end());
    triangles.erase(affected, triangles.end());
    for (const Edge& edge : boundary(broken)) triangles.push_back({edge.first, edge.second, p});
  }

  std::erase_if(triangles, [&](const Triangle& t) {
    constexpr double kFlat = 1e-6;
    return std::ranges::any_of(t, [&](std::size_t i) { return i >= count; }) ||
           doubled_area(all[t[0]], all[t[1]], all[t[2]]) < kFlat;
  });
  return triangles;
}

}  // namespace cls::player
