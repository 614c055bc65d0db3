// What an agent believes about another player.
#pragma once

#include <array>
#include <cmath>

#include "proxy/world/age.h"
#include "proxy/world/fixed_list.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/side.h"

namespace cls::proxy {

/// One tracked player. Metres, metres per cycle, own team attacks +x; angles are global. `side` is
/// the server's side.
struct PlayerState {
  int id = 0;  ///< own number of this track, from 1; a player that is lost and found gets a new one
  soccer::Side side = soccer::Side::kNeutral;  ///< neutral: team not known
  int unum = 0;                                ///< 0: number not known
  int unum_count = kNever;                     ///< since the number was seen or heard
  bool goalie = false;  ///< seen with the goalie's mark, or reckoned to be it
  int type_id = 0;      ///< -1 while the number is unknown

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
  int ghost_count = 0;        ///< looks in a row that did not find it where it was expected
  int kick_count = kNever;    ///< since it was seen kicking
  int tackle_count = kNever;  ///< since it was seen tackling

  // Derived when the world model is completed for a decision.
  bool kicking = false;   ///< seen kicking now
  bool tackling = false;  ///< believed to lie after a tackle
  double dist_from_self = 1000.0;
  soccer::AngleDeg angle_from_self;  ///< global direction self to player
  double dist_from_ball = 1000.0;
  soccer::AngleDeg angle_from_ball;  ///< global direction ball to player
  int ball_reach_steps = kNever;     ///< kNever: not reckoned, or never

  /// Covariance of (x, y, vx, vy), row by row; the tracker's own.
  std::array<double, 16> covariance{};
  bool claimed = false;  ///< the present look shows it; the tracker's own

  bool position_valid() const { return pos_count < kPlayerPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kPlayerVelocityAgeLimit; }
  bool ghost() const { return ghost_count > 0; }
  /// Standard deviation of the position along its worse axis, metres.
  double position_deviation() const {
    return std::sqrt(covariance[0] > covariance[5] ? covariance[0] : covariance[5]);
  }
};

/// Tracks of one team: those with a number first, by number, then the others by id.
using PlayerList = FixedList<PlayerState, 22>;

/// Where the player comes to rest when it never dashes again.
inline soccer::Vec2 inertia_final_point(const PlayerState& player, double decay) {
  return player.position + player.velocity / (1.0 - decay);
}

}  // namespace cls::proxy
