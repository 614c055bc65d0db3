// Estimate of the ball.
#pragma once

#include "player/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"

namespace cls::player {

/// Meters, meters per cycle, own team attacks +x. `position` and `velocity` are advanced every
/// cycle (velocity, ball decay, own kicks); seen_ and heard_ values stay as observed. A value never
/// observed is zero with age kNever.
struct BallState {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  soccer::Vec2 relative_position;  ///< position minus own position, pitch axes
  soccer::Vec2 seen_position;
  soccer::Vec2 seen_relative_position;
  soccer::Vec2 seen_velocity;
  soccer::Vec2 heard_position;
  soccer::Vec2 heard_velocity;
  double position_deviation = 0.0;  ///< standard deviation along the less certain axis, meters
  double velocity_deviation = 0.0;

  int pos_count = kNever;  ///< since the position was updated by see or hear
  int relative_pos_count = kNever;
  int seen_pos_count = kNever;
  int heard_pos_count = kNever;
  int vel_count = kNever;
  int seen_vel_count = kNever;
  int heard_vel_count = kNever;
  int lost_count = 0;   ///< cycles since the ball became a ghost, untracked or invalid
  int ghost_count = 0;  ///< consecutive see messages that did not show it at its estimate

  // Derived from position and the own position.
  double dist_from_self = 1000.0;
  soccer::AngleDeg angle_from_self;  ///< global direction self to ball

  bool position_valid() const { return pos_count < kBallPositionAgeLimit; }
  bool relative_position_valid() const { return relative_pos_count < kBallRelativeAgeLimit; }
  bool velocity_valid() const { return vel_count < kBallVelocityAgeLimit; }
};

}  // namespace cls::player
