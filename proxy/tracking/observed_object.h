// A ball or player of a see message as intervals on its place and velocity.
#pragma once

#include "proxy/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::proxy {

/// Belief about (x, y, vx, vy) of a moving object; the velocity is what a step without push adds.
using MovingBelief = Gaussian<4>;

/// From where an object is seen: own pose and its uncertainty, own velocity.
struct Viewpoint {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  double face = 0.0;               ///< degrees
  double position_variance = 0.0;  ///< per axis, square metres
  double face_variance = 0.0;      ///< square degrees
  double focus_distance = 0.0;
  soccer::Vec2 focus;
};

Viewpoint viewpoint(const WorldModel& world);

/// Where a look puts an object.
struct Sight {
  soccer::Vec2 position;   ///< middle of the feasible patch
  soccer::Vec2 direction;  ///< unit vector from the viewpoint
  DistanceRange range;
  double distance = 0.0;
  double along_variance = 0.0;   ///< of the position along `direction`
  double across_variance = 0.0;  ///< and across it
};

Sight sight_of(const Viewpoint& view, const DistanceTable& distances,
               const soccer::Observation& seen);

/// How far, in squared standard deviations, the belief's position is from a sight, and the
/// logarithm of the determinant of their common covariance.
struct Misfit {
  double squared = 0.0;
  double log_determinant = 0.0;
};
Misfit misfit(const MovingBelief& belief, const Sight& sight);

/// Takes one look into the belief: distance and direction, and their changes when they are told.
void observe(MovingBelief& belief, const Viewpoint& view, const Sight& sight,
             const soccer::Observation& seen);

/// A belief out of one look alone; where the velocity is not told it is `velocity` with
/// `velocity_variance` per axis.
MovingBelief first_belief(const Viewpoint& view, const Sight& sight,
                          const soccer::Observation& seen, soccer::Vec2 velocity,
                          double velocity_variance);

}  // namespace cls::proxy
