// Interpolates player positions between the samples of a formation.
#include "player/formation/formation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cls::player {
namespace {

/// Edges for samples without triangles, which lie on one line: joins neighbors along it.
std::vector<Edge> chain_edges(const std::vector<Vec2>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(points[i].x, points[i].y); });

  std::vector<Edge> chain;
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
      formation.triangles_.empty() ? chain_edges(points) : boundary(formation.triangles_);
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
  if (hull_.empty()) return samples_.front().players;
  const auto foot_on = [&](const Edge& edge) {
    return soccer::nearest_point({samples_[edge.first].ball, samples_[edge.second].ball}, ball);
  };
  const Edge& edge = *std::ranges::min_element(
      hull_, {}, [&](const Edge& one) { return squared_distance(foot_on(one), ball); });

  const Vec2 from = samples_[edge.first].ball;
  const Vec2 way = samples_[edge.second].ball - from;
  const double share = dot(foot_on(edge) - from, way) / way.squared_length();
  return interpolate({edge.first, edge.second, edge.second}, {1.0 - share, share, 0.0});
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
