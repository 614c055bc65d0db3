// Interpolates player positions between the samples of a formation.
#include "player/formation/formation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace cls::player {
namespace {

using soccer::Vec2;

std::vector<std::array<std::size_t, 2>> hull_edges(const std::vector<Triangle>& triangles) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<std::size_t, 2> edge{t[i], t[(i + 1) % 3]};
      const auto twin =
          std::find(edges.begin(), edges.end(), std::array<std::size_t, 2>{edge[1], edge[0]});
      if (twin == edges.end()) {
        edges.push_back(edge);
      } else {
        edges.erase(twin);
      }
    }
  }

  return edges;
}

/// Edges for samples without triangles, which lie on one line: joins neighbors along it.
std::vector<std::array<std::size_t, 2>> chain_edges(const std::vector<Vec2>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
  });

  std::vector<std::array<std::size_t, 2>> chain;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) chain.push_back({order[i], order[i + 1]});
  return chain;
}

}  // namespace

base::Result<Formation> Formation::make(std::vector<FormationSample> samples) {
  if (samples.empty()) return base::Error{"no samples"};

  constexpr double kSame = 0.05;
  std::vector<Vec2> points;
  for (const FormationSample& sample : samples) {
    for (const Vec2 other : points) {
      if (distance(other, sample.ball) >= kSame) continue;
      return base::Error{
          fmt::format("two samples with the ball at ({}, {})", sample.ball.x, sample.ball.y)};
    }
    points.push_back(sample.ball);
  }

  Formation formation;
  formation.samples_ = std::move(samples);
  formation.triangles_ = triangulate(points);
  formation.hull_ =
      formation.triangles_.empty() ? chain_edges(points) : hull_edges(formation.triangles_);
  return formation;
}

TeamPoints Formation::interpolate(const std::array<std::size_t, 3>& corners,
                                  const std::array<double, 3>& weights) const {
  TeamPoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = samples_[corners[0]].players[i] * weights[0] +
                samples_[corners[1]].players[i] * weights[1] +
                samples_[corners[2]].players[i] * weights[2];
  }
  return points;
}

TeamPoints Formation::nearest_on_hull(Vec2 ball) const {
  double least = 0.0;
  const std::array<std::size_t, 2>* nearest = nullptr;
  Vec2 foot;

  for (const auto& edge : hull_) {
    const Vec2 point =
        soccer::nearest_point({samples_[edge[0]].ball, samples_[edge[1]].ball}, ball);
    const double away = squared_distance(point, ball);
    if (nearest != nullptr && away >= least) continue;
    least = away;
    nearest = &edge;
    foot = point;
  }

  if (nearest == nullptr) return samples_.front().players;
  const Vec2 from = samples_[(*nearest)[0]].ball;
  const Vec2 way = samples_[(*nearest)[1]].ball - from;
  const double share = dot(foot - from, way) / way.squared_length();
  return interpolate({(*nearest)[0], (*nearest)[1], (*nearest)[1]}, {1.0 - share, share, 0.0});
}

TeamPoints Formation::positions(Vec2 ball) const {
  for (const Triangle& t : triangles_) {
    const Vec2 a = samples_[t[0]].ball;
    const Vec2 b = samples_[t[1]].ball;
    const Vec2 c = samples_[t[2]].ball;
    const double of_a = cross(c - b, ball - b);
    const double of_b = cross(a - c, ball - c);
    const double of_c = cross(b - a, ball - a);
    if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;

    const double whole = of_a + of_b + of_c;
    return interpolate(t, {of_a / whole, of_b / whole, of_c / whole});
  }
  return nearest_on_hull(ball);
}

}  // namespace cls::player
