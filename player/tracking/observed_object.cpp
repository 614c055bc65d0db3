// Interval observations of a moving object in a see message.
#include "player/tracking/observed_object.h"

#include <algorithm>
#include <span>

namespace cls::player {
namespace {

using soccer::Observation;
using soccer::ObservedDetail;

constexpr double kHalfDegree = math::to_radians(0.5);
constexpr double kUniformVariance = 1.0 / 3.0;  // of a uniform distribution of half width 1

Vec2 perpendicular(Vec2 v) { return {-v.y, v.x}; }

bool has_motion(const Observation& seen) { return seen.detail >= ObservedDetail::kMotion; }

/// The estimate in the frame whose first axis is the unit vector `e`: x along it, y across it.
ObjectEstimate in_frame(const ObjectEstimate& estimate, Vec2 e) {
  const auto along = [e](double x, double y) { return e.x * x + e.y * y; };
  const auto across = [e](double x, double y) { return e.x * y - e.y * x; };

  ObjectEstimate out;
  for (std::size_t r = 0; r < 4; r += 2) {
    out.mean[r] = along(estimate.mean[r], estimate.mean[r + 1]);
    out.mean[r + 1] = across(estimate.mean[r], estimate.mean[r + 1]);
    for (std::size_t c = 0; c < 4; c += 2) {
      const double along_x = along(estimate.at(r, c), estimate.at(r + 1, c));
      const double along_y = along(estimate.at(r, c + 1), estimate.at(r + 1, c + 1));
      const double across_x = across(estimate.at(r, c), estimate.at(r + 1, c));
      const double across_y = across(estimate.at(r, c + 1), estimate.at(r + 1, c + 1));
      out.at(r, c) = along(along_x, along_y);
      out.at(r, c + 1) = across(along_x, along_y);
      out.at(r + 1, c) = along(across_x, across_y);
      out.at(r + 1, c + 1) = across(across_x, across_y);
    }
  }
  return out;
}

/// The inverse of in_frame().
ObjectEstimate from_frame(const ObjectEstimate& estimate, Vec2 e) {
  return in_frame(estimate, {e.x, -e.y});
}

// Components of an estimate in the frame of the line of sight.
constexpr std::size_t kAlong = 0;
constexpr std::size_t kAcross = 1;
constexpr std::size_t kVelocityAlong = 2;
constexpr std::size_t kVelocityAcross = 3;

using SlabList = base::FixedList<AxisSlab, 4>;

/// The same interval as one of the general form.
Slab<4> joint(const AxisSlab& slab) {
  Slab<4> out{{}, slab.low, slab.high, slab.noise_variance};
  out.direction[slab.axis] = 1.0;
  return out;
}

using JointSlabList = base::FixedList<Slab<4>, 4>;

/// With Gaussian noise the printed distance change is the true one times printed over true
/// distance, and the true direction change is printed: both observe velocity and distance jointly,
/// here in the frame of the line of sight.
void add_gaussian_motion(const Viewpoint& view, const ObservedPosition& observed,
                         const Observation& seen, JointSlabList& slabs) {
  // The sensed own velocity is rounded, and the direction to the object is known to a degree.
  constexpr double kOwnVelocityVariance = 0.004 * 0.004;
  const double d = std::max(observed.distance, 0.1);
  const Vec2 e = observed.direction;
  const double own_along = soccer::dot(e, view.position);
  const double angle_variance =
      kUniformVariance * square(kHalfDegree) + square(math::to_radians(1.0)) * view.face_variance;

  const double radial = seen.distance_change / d;  // per meter
  const double turning = math::to_radians(seen.direction_change);
  const auto add = [&](std::size_t component, Vec2 axis, double per_meter, double across_per_meter,
                       double half) {
    const double middle = soccer::dot(axis, view.velocity) - per_meter * own_along;
    const double noise = kOwnVelocityVariance + square(per_meter) * view.position_variance +
                         square(across_per_meter * d) * angle_variance;
    Slab<4> slab{{}, middle - half, middle + half, noise};
    slab.direction[kAlong] = -per_meter;
    slab.direction[component] = 1.0;
    slabs.push_back(slab);
  };
  add(kVelocityAlong, e, radial, turning, 0.5 * soccer::kGaussianDistanceChangeStep);
  add(kVelocityAcross, perpendicular(e), turning, radial,
      math::to_radians(0.5 * soccer::kDirectionChangeStep) * d);
}

void add_motion(const Viewpoint& view, const ObservedPosition& observed, const Observation& seen,
                SlabList& slabs) {
  const double d = observed.distance;
  const double d_variance = observed.along_variance;
  const Vec2 e = observed.direction;
  const Vec2 n = perpendicular(e);

  const double printed = std::max(seen.distance, 0.1);
  const double ratio = math::quantize(seen.distance_change / printed, soccer::kDistanceChangeStep);

  const double own_radial = soccer::dot(e, view.velocity);
  const double radial_half = 0.5 * soccer::kDistanceChangeStep * d;
  slabs.push_back({kVelocityAlong, own_radial + ratio * d - radial_half,
                   own_radial + ratio * d + radial_half, d_variance * square(ratio)});

  const double turning = math::to_radians(seen.direction_change);
  const double own_across = soccer::dot(n, view.velocity);
  const double across_half = math::to_radians(0.5 * soccer::kDirectionChangeStep) * d;
  slabs.push_back({kVelocityAcross, own_across + turning * d - across_half,
                   own_across + turning * d + across_half, d_variance * square(turning)});
}

}  // namespace

void advance_estimate(ObjectEstimate& estimate, double carry, double factor, double noise_variance,
                      double decay) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    estimate.mean[axis] += carry * estimate.mean[axis + 2];
    estimate.mean[axis + 2] *= factor;
  }

  // z' = F z for the rows and the columns of the covariance.
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      estimate.at(axis, c) += carry * estimate.at(axis + 2, c);
      estimate.at(axis + 2, c) *= factor;
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      estimate.at(r, axis) += carry * estimate.at(r, axis + 2);
      estimate.at(r, axis + 2) *= factor;
    }
  }

  for (std::size_t axis = 0; axis < 2; ++axis) {
    estimate.at(axis, axis) += noise_variance;
    estimate.at(axis, axis + 2) += noise_variance * decay;
    estimate.at(axis + 2, axis) += noise_variance * decay;
    estimate.at(axis + 2, axis + 2) += noise_variance * decay * decay;
  }
}

Viewpoint viewpoint(const WorldModel& world) {
  const SelfState& self = world.self;
  const Gaussian<3>& pose = world.self_tracker.pose;

  const double face = self.face().degrees();
  return {.position = self.position,
          .velocity = self.velocity,
          .face = face,
          .position_variance = 0.5 * (pose.at(0, 0) + pose.at(1, 1)),
          .face_variance = pose.at(2, 2),
          .focus_distance = self.focus_distance,
          .focus = self.position + soccer::polar_degrees(self.focus_distance,
                                                         face + self.focus_direction.degrees()),
          .gaussian = self.gaussian_see,
          .noise_rate = world.self_type().dist_noise_rate,
          .focus_noise_rate = world.self_type().focus_dist_noise_rate};
}

ObservedPosition observed_position(const Viewpoint& view, const DistanceTable& distances,
                                   const Observation& seen) {
  ObservedPosition observed;
  observed.direction = soccer::polar_degrees(1.0, view.face + seen.direction);
  if (view.gaussian) {
    observed.range = {seen.distance, seen.distance};
    const Vec2 position = view.position + observed.direction * seen.distance;
    observed.distance_variance =
        gaussian_distance_variance(view.noise_rate, seen.distance, view.focus_noise_rate,
                                   soccer::distance(position, view.focus));
  } else if (view.focus_distance > 0.0) {
    observed.range =
        distances.range_along(seen.distance, view.position, observed.direction, view.focus);
  } else {
    observed.range = distances.range(seen.distance);
  }

  observed.distance = observed.range.middle();
  observed.position = view.position + observed.direction * observed.distance;

  const double half = 0.5 * (observed.range.high - observed.range.low);
  observed.along_variance =
      kUniformVariance * square(half) + observed.distance_variance + view.position_variance;
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

  const AxisSlab along{kAlong, own_along + observed.range.low, own_along + observed.range.high,
                       view.position_variance + observed.distance_variance};
  const AxisSlab across{kAcross, own_across - half_across, own_across + half_across,
                        view.position_variance + face};

  constexpr int kSweeps = 3;
  ObjectEstimate seen_from_here = in_frame(estimate, e);
  if (view.gaussian) {
    JointSlabList slabs;
    for (const AxisSlab& slab : {along, across}) slabs.push_back(joint(slab));
    if (has_motion(seen)) add_gaussian_motion(view, observed, seen, slabs);
    condition(seen_from_here, std::span<const Slab<4>>(slabs.begin(), slabs.size()), kSweeps);
  } else {
    SlabList slabs;
    slabs.push_back(along);
    slabs.push_back(across);
    if (has_motion(seen)) add_motion(view, observed, seen, slabs);
    condition(seen_from_here, std::span<const AxisSlab>(slabs.begin(), slabs.size()), kSweeps);
  }
  estimate = from_frame(seen_from_here, e);
}

ObjectEstimate initial_estimate(const Viewpoint& view, const ObservedPosition& observed,
                                const Observation& seen, Vec2 velocity, double velocity_variance) {
  const Vec2 e = observed.direction;
  const Vec2 n = perpendicular(e);

  ObjectEstimate estimate;  // in the frame of the line of sight
  estimate.mean = {soccer::dot(e, observed.position), soccer::dot(n, observed.position),
                   soccer::dot(e, velocity), soccer::dot(n, velocity)};
  estimate.at(kAlong, kAlong) = observed.along_variance;
  estimate.at(kAcross, kAcross) = observed.across_variance;
  estimate.at(kVelocityAlong, kVelocityAlong) = velocity_variance;
  estimate.at(kVelocityAcross, kVelocityAcross) = velocity_variance;

  if (has_motion(seen) && view.gaussian) {
    JointSlabList slabs;
    add_gaussian_motion(view, observed, seen, slabs);
    for (const Slab<4>& slab : slabs) condition(estimate, slab);
  } else if (has_motion(seen)) {
    SlabList slabs;
    add_motion(view, observed, seen, slabs);
    for (const AxisSlab& slab : slabs) condition(estimate, slab);
  }

  return from_frame(estimate, e);
}

}  // namespace cls::player
