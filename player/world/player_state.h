// Estimate of another player.
#pragma once

#include <array>
#include <cmath>

#include "base/fixed_list.h"
#include "player/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/side.h"

namespace cls::player {

/// One tracked player. Meters, meters per cycle, own team attacks +x; global angles. `side` is the
/// server's.
struct PlayerState {
  int id = 0;  ///< id of this track, from 1; a player lost and found again gets a new id
  soccer::Side side = soccer::Side::kNeutral;  ///< neutral: unknown team
  int unum = 0;                                ///< 0: unknown
  int unum_count = kNever;                     ///< since the number was seen
  bool goalie = false;                         ///< seen with the goalie mark, or inferred
  int type_id = 0;                             ///< -1 while the number is unknown

  soccer::Vec2 position;
  soccer::Vec2 velocity;
  soccer::Vec2 seen_position;
  soccer::Vec2 seen_velocity;
  soccer::Vec2 heard_position;
  soccer::AngleDeg body;
  soccer::AngleDeg face;  ///< body plus neck
  soccer::AngleDeg point_direction;

  int pos_count = kNever;
  int seen_pos_count = kNever;
  int heard_pos_count = kNever;
  int vel_count = kNever;
  int seen_vel_count = kNever;
  int body_count = kNever;
  int face_count = kNever;
  int point_count = kNever;
  int ghost_count = 0;        ///< consecutive see messages that did not show it at its estimate
  int kick_count = kNever;    ///< since it was seen kicking
  int tackle_count = kNever;  ///< since it was seen tackling

  // Set by update_derived().
  bool kicking = false;   ///< seen kicking now
  bool tackling = false;  ///< estimated to be down after a tackle
  double dist_from_self = 1000.0;
  soccer::AngleDeg angle_from_self;  ///< global direction self to player
  double dist_from_ball = 1000.0;
  soccer::AngleDeg angle_from_ball;  ///< global direction ball to player
  int ball_reach_steps = kNever;     ///< kNever: not computed, or never

  /// Covariance of (x, y, vx, vy), row-major; used by the tracker only.
  std::array<double, 16> covariance{};
  bool matched = false;  ///< matched by the current see message; used by the tracker only

  bool position_valid() const { return pos_count < kPlayerPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kPlayerVelocityAgeLimit; }
  bool ghost() const { return ghost_count > 0; }
  /// Standard deviation of the position along its less certain axis, meters.
  double position_deviation() const {
    return std::sqrt(covariance[0] > covariance[5] ? covariance[0] : covariance[5]);
  }
};

/// Tracks of one team: numbered players by number, then the others by id.
using PlayerList = base::FixedList<PlayerState, 22>;

}  // namespace cls::player
