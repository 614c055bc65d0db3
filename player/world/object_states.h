// Estimates of the ball, the agent and the other players.
#pragma once

#include <array>
#include <cmath>

#include "base/fixed_list.h"
#include "player/world/age.h"
#include "player/world/vocabulary.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::player {

/// Meters, meters per cycle, own team attacks +x. `position` and `velocity` are advanced every
/// cycle (velocity, ball decay, own kicks); seen_ and heard_ values stay as observed. A value never
/// observed is zero with age kNever.
struct BallState {
  Vec2 position;
  Vec2 velocity;
  Vec2 relative_position;  ///< position minus own position, pitch axes
  Vec2 seen_position;
  Vec2 seen_relative_position;
  Vec2 seen_velocity;
  Vec2 heard_position;
  Vec2 heard_velocity;
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
  AngleDeg angle_from_self;  ///< global direction self to ball

  bool position_valid() const { return pos_count < kBallPositionAgeLimit; }
  bool relative_position_valid() const { return relative_pos_count < kBallRelativeAgeLimit; }
  bool velocity_valid() const { return vel_count < kBallVelocityAgeLimit; }
  /// Zero where it is unknown.
  Vec2 known_velocity() const { return velocity_valid() ? velocity : Vec2{}; }
};

/// Meters, meters per cycle (displacement of the next step), own team attacks +x. Velocity, stamina
/// and counters come from sense_body, position and body from landmarks; between see messages by
/// dead reckoning.
struct SelfState {
  Vec2 position;
  Vec2 velocity;
  Vec2 seen_position;  ///< at the last see message; not advanced
  Vec2 seen_velocity;
  AngleDeg body;
  AngleDeg neck;                  ///< relative to the body
  double position_deviation = 0;  ///< standard deviation of position per axis, meters
  double body_deviation = 0;      ///< standard deviation of body, degrees

  int pos_count = kNever;  ///< since localized by landmarks or an own move command
  int seen_pos_count = kNever;
  int vel_count = kNever;
  int seen_vel_count = kNever;
  int body_count = kNever;  ///< since body and face were taken from landmarks

  double stamina = 0.0;
  double effort = 1.0;
  double recovery = 1.0;   ///< computed; the server does not report it
  double capacity = -1.0;  ///< remaining stamina reserve; negative: unlimited

  soccer::CommandCounts counts;
  soccer::ViewWidth view_width = soccer::ViewWidth::kNormal;
  soccer::ViewQuality view_quality = soccer::ViewQuality::kHigh;
  bool gaussian_see = false;    ///< seen distances have Gaussian noise and no quantization
  double focus_distance = 0.0;  ///< meters
  AngleDeg focus_direction;     ///< relative to the face

  soccer::ArmState arm;
  AngleDeg point_direction;  ///< global direction of the own arm
  int point_count = kNever;  ///< since the arm was pointed; kNever when it is down
  Side attention_side = Side::kNeutral;
  int attention_unum = 0;

  int tackle_count = 0;       ///< tackles executed so far
  int tackle_expires_in = 0;  ///< cycles left on the ground after a tackle
  int foul_charged = 0;       ///< cycles left on the ground after being fouled
  bool collided_with_ball = false;
  bool collided_with_player = false;
  bool collided_with_post = false;
  soccer::Card card = soccer::Card::kNone;
  int type_id = 0;
  bool kicked = false;  ///< the agent's kick was executed in the last step
  int catch_time = 0;   ///< cycle of the last executed catch command; 0: none
  int catch_ban = 0;    ///< cycles until the next catch is allowed

  // Set by update_derived().
  bool kickable = false;
  double kick_rate = 0.0001;  ///< current ball acceleration per unit of kick power
  double catch_probability = 0.0;
  double tackle_probability = 0.0;
  double foul_probability = 0.0;
  double safety_dash_power = 0.0;  ///< maximum power that does not decrease recovery

  AngleDeg face() const { return body + neck; }
  bool frozen() const { return tackle_expires_in > 0 || foul_charged > 0; }
  bool tackling() const { return tackle_expires_in > 0; }
  bool position_valid() const { return pos_count < kSelfPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kSelfVelocityAgeLimit; }
  bool face_valid() const { return body_count < kSelfFaceAgeLimit; }
};

/// One tracked player. Meters, meters per cycle, own team attacks +x; global angles. `side` is the
/// server's.
struct PlayerState {
  int id = 0;  ///< id of this track, from 1; a player lost and found again gets a new id
  Side side = Side::kNeutral;  ///< neutral: unknown team
  int unum = 0;                ///< 0: unknown
  int unum_count = kNever;     ///< since the number was seen
  bool goalie = false;         ///< seen with the goalie mark, or inferred
  int type_id = 0;             ///< -1 while the number is unknown

  Vec2 position;
  Vec2 velocity;
  Vec2 seen_position;
  Vec2 seen_velocity;
  Vec2 heard_position;
  AngleDeg body;
  AngleDeg face;  ///< body plus neck
  AngleDeg point_direction;

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
  AngleDeg angle_from_self;  ///< global direction self to player
  double dist_from_ball = 1000.0;
  AngleDeg angle_from_ball;       ///< global direction ball to player
  int ball_reach_steps = kNever;  ///< kNever: not computed, or never

  /// Covariance of (x, y, vx, vy), row-major; used by the tracker only.
  std::array<double, 16> covariance{};
  bool matched = false;  ///< matched by the current see message; used by the tracker only

  bool position_valid() const { return pos_count < kPlayerPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kPlayerVelocityAgeLimit; }
  /// Zero where it is unknown.
  Vec2 known_velocity() const { return velocity_valid() ? velocity : Vec2{}; }
  bool ghost() const { return ghost_count > 0; }
  /// Standard deviation of the position along its less certain axis, meters.
  double position_deviation() const {
    return std::sqrt(covariance[0] > covariance[5] ? covariance[0] : covariance[5]);
  }
};

/// Tracks of one team: numbered players by number, then the others by id.
using PlayerList = base::FixedList<PlayerState, 22>;

}  // namespace cls::player
