// Observed ball or player of a see message as intervals on its position and velocity.
#pragma once

#include <array>

#include "player/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::player {

/// Estimate of (x, y, vx, vy); velocity is the displacement of a step without acceleration.
using ObjectEstimate = Gaussian<4>;

/// Observer: own pose with uncertainty, own velocity, focus point.
struct Viewpoint {
  Vec2 position;
  Vec2 velocity;
  double face = 0.0;               ///< degrees
  double position_variance = 0.0;  ///< per axis, square meters
  double face_variance = 0.0;      ///< square degrees
  double focus_distance = 0.0;
  Vec2 focus;
  bool gaussian = false;          ///< distances have Gaussian noise
  double noise_rate = 0.0;        ///< of it, per meter of distance
  double focus_noise_rate = 0.0;  ///< per meter from the focus point
};

Viewpoint viewpoint(const WorldModel& world);

/// Advances an estimate by a step: the position by `carry` times the velocity, the velocity by
/// `factor`. Noise with `noise_variance` per axis moves the object, and decays to its velocity.
void advance_estimate(ObjectEstimate& estimate, double carry, double factor, double noise_variance,
                      double decay);

/// Position of an object according to one see message.
struct ObservedPosition {
  Vec2 position;                   ///< middle of the feasible region
  Vec2 direction;                  ///< unit vector from the viewpoint
  DistanceRange range;             ///< without Gaussian noise
  double distance_variance = 0.0;  ///< Gaussian noise
  double distance = 0.0;
  double along_variance = 0.0;   ///< of the position along `direction`
  double across_variance = 0.0;  ///< across it
};

ObservedPosition observed_position(const Viewpoint& view, const DistanceTable& distances,
                                   const soccer::Observation& seen);

/// Squared Mahalanobis distance between estimated and observed position, and the determinant of
/// their joint covariance.
struct MahalanobisDistance {
  double squared = 0.0;
  double determinant = 0.0;
};
/// `covariance` is that of an ObjectEstimate.
MahalanobisDistance mahalanobis_distance(Vec2 position, const std::array<double, 16>& covariance,
                                         const ObservedPosition& observed);
inline MahalanobisDistance mahalanobis_distance(const ObjectEstimate& estimate,
                                                const ObservedPosition& observed) {
  return mahalanobis_distance({estimate.mean[0], estimate.mean[1]}, estimate.covariance, observed);
}

/// Updates the estimate by distance, direction and, if present, their changes.
void update_estimate(ObjectEstimate& estimate, const Viewpoint& view,
                     const ObservedPosition& observed, const soccer::Observation& seen);

/// Estimate from a single observation; without observed motion the velocity is `velocity` with
/// `velocity_variance` per axis.
ObjectEstimate initial_estimate(const Viewpoint& view, const ObservedPosition& observed,
                                const soccer::Observation& seen, Vec2 velocity,
                                double velocity_variance);

}  // namespace cls::player
