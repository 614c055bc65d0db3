// Interval observations of a moving object in a see message.
#include "player/tracking/observed_object.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "soccer/math.h"

namespace cls::player {
namespace {

namespace math = soccer::math;
using soccer::Observation;
using soccer::ObservedDetail;
using soccer::Vec2;

constexpr double kHalfDegree = math::to_radians(0.5);
constexpr double kUniformVariance = 1.0 / 3.0;  // of a uniform distribution of half width 1

// Quantization steps (docs/spec/simulation-model.md 7.5): of distance change over distance, and of
// direction change in degrees.
constexpr double kDistanceChangeStep = 0.02;
constexpr double kDirectionChangeStep = 0.1;

Vec2 perpendicular(Vec2 v) { return {-v.y, v.x}; }

bool has_motion(const Observation& seen) { return seen.detail >= ObservedDetail::kMotion; }

double square(double x) { return x * x; }

using SlabList = base::FixedList<Slab<4>, 4>;

void add_motion(const Viewpoint& view, const ObservedPosition& observed, const Observation& seen,
                SlabList& slabs) {
  const double d = observed.distance;
  const double d_variance = observed.along_variance;
  const Vec2 e = observed.direction;
  const Vec2 n = perpendicular(e);

  const double printed = std::max(seen.distance, 0.1);
  const double ratio = math::quantize(seen.distance_change / printed, kDistanceChangeStep);

  const double own_radial = soccer::dot(e, view.velocity);
  const double radial_half = 0.5 * kDistanceChangeStep * d;
  slabs.push_back({{0.0, 0.0, e.x, e.y},
                   own_radial + ratio * d - radial_half,
                   own_radial + ratio * d + radial_half,
                   d_variance * square(ratio)});

  const double turning = math::to_radians(seen.direction_change);
  const double own_across = soccer::dot(n, view.velocity);
  const double across_half = math::to_radians(0.5 * kDirectionChangeStep) * d;
  slabs.push_back({{0.0, 0.0, n.x, n.y},
                   own_across + turning * d - across_half,
                   own_across + turning * d + across_half,
                   d_variance * square(turning)});
}

}  // namespace

Viewpoint viewpoint(const WorldModel& world) {
  const SelfState& self = world.self;
  const Gaussian<3>& pose = world.self_tracker.pose;

  Viewpoint view;
  view.position = self.position;
  view.velocity = self.velocity;
  view.face = self.face().degrees();
  view.position_variance = 0.5 * (pose.at(0, 0) + pose.at(1, 1));
  view.face_variance = pose.at(2, 2);
  view.focus_distance = self.focus_distance;
  view.focus = self.position + soccer::polar_degrees(self.focus_distance,
                                                     view.face + self.focus_direction.degrees());

  return view;
}

ObservedPosition observed_position(const Viewpoint& view, const DistanceTable& distances,
                                   const Observation& seen) {
  ObservedPosition observed;
  observed.direction = soccer::polar_degrees(1.0, view.face + seen.direction);
  observed.range = distances.range(seen.distance);
  if (view.focus_distance > 0.0) {
    observed.range =
        distances.range_along(seen.distance, view.position, observed.direction, view.focus);
  }

  observed.distance = observed.range.middle();
  observed.position = view.position + observed.direction * observed.distance;

  const double half = 0.5 * (observed.range.high - observed.range.low);
  observed.along_variance = kUniformVariance * square(half) + view.position_variance;
  observed.across_variance =
      square(observed.distance) * (kUniformVariance * square(kHalfDegree) +
                                   square(math::to_radians(1.0)) * view.face_variance) +
      view.position_variance;
  return observed;
}

MahalanobisDistance mahalanobis_distance(Vec2 position, const std::array<double, 16>& covariance,
                                         const ObservedPosition& observed) {
  const Vec2 e = observed.direction;

  const double a = observed.along_variance;
  const double c = observed.across_variance;
  const double xx = covariance[0] + a * e.x * e.x + c * e.y * e.y;
  const double yy = covariance[5] + a * e.y * e.y + c * e.x * e.x;
  const double xy = covariance[1] + (a - c) * e.x * e.y;

  const double determinant = std::max(xx * yy - xy * xy, 1e-12);
  const Vec2 d = observed.position - position;
  const double squared = (yy * d.x * d.x - 2.0 * xy * d.x * d.y + xx * d.y * d.y) / determinant;
  return {squared, determinant};
}

void update_estimate(ObjectEstimate& estimate, const Viewpoint& view,
                     const ObservedPosition& observed, const Observation& seen) {
  const Vec2 e = observed.direction;
  const Vec2 n = perpendicular(e);
  const double face = square(math::to_radians(1.0) * observed.distance) * view.face_variance;
  const double half_across = kHalfDegree * observed.distance;
  const double own_along = soccer::dot(e, view.position);
  const double own_across = soccer::dot(n, view.position);

  SlabList slabs;
  slabs.push_back({{e.x, e.y, 0.0, 0.0},
                   own_along + observed.range.low,
                   own_along + observed.range.high,
                   view.position_variance});
  slabs.push_back({{n.x, n.y, 0.0, 0.0},
                   own_across - half_across,
                   own_across + half_across,
                   view.position_variance + face});

  if (has_motion(seen)) add_motion(view, observed, seen, slabs);
  constexpr int kSweeps = 3;
  condition<4>(estimate, std::span<const Slab<4>>(slabs.begin(), slabs.size()), kSweeps);
}

ObjectEstimate initial_estimate(const Viewpoint& view, const ObservedPosition& observed,
                                const Observation& seen, Vec2 velocity, double velocity_variance) {
  ObjectEstimate estimate;
  estimate.mean = {observed.position.x, observed.position.y, velocity.x, velocity.y};

  const Vec2 e = observed.direction;
  const double a = observed.along_variance;
  const double c = observed.across_variance;

  estimate.at(0, 0) = a * e.x * e.x + c * e.y * e.y;
  estimate.at(1, 1) = a * e.y * e.y + c * e.x * e.x;
  estimate.at(0, 1) = estimate.at(1, 0) = (a - c) * e.x * e.y;
  estimate.at(2, 2) = estimate.at(3, 3) = velocity_variance;

  if (has_motion(seen)) {
    SlabList slabs;
    add_motion(view, observed, seen, slabs);
    for (const Slab<4>& slab : slabs) condition(estimate, slab);
  }

  return estimate;
}

}  // namespace cls::player
