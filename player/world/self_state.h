// Estimate of the agent itself.
#pragma once

#include "player/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"
#include "soccer/messages/sense_body.h"

namespace cls::player {

/// Meters, meters per cycle (displacement of the next step), own team attacks +x. Velocity, stamina
/// and counters come from sense_body, position and body from landmarks; between see messages by
/// dead reckoning.
struct SelfState {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  soccer::Vec2 seen_position;  ///< at the last see message; not advanced
  soccer::Vec2 seen_velocity;
  soccer::AngleDeg body;
  soccer::AngleDeg neck;          ///< relative to the body
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
  bool gaussian_see = false;         ///< seen distances have Gaussian noise and no quantization
  double focus_distance = 0.0;       ///< meters
  soccer::AngleDeg focus_direction;  ///< relative to the face

  soccer::ArmState arm;
  soccer::AngleDeg point_direction;  ///< global direction of the own arm
  int point_count = kNever;          ///< since the arm was pointed; kNever when it is down
  soccer::Side attention_side = soccer::Side::kNeutral;
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

  soccer::AngleDeg face() const { return body + neck; }
  bool frozen() const { return tackle_expires_in > 0 || foul_charged > 0; }
  bool tackling() const { return tackle_expires_in > 0; }
  bool position_valid() const { return pos_count < kSelfPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kSelfVelocityAgeLimit; }
  bool face_valid() const { return body_count < kSelfFaceAgeLimit; }
};

}  // namespace cls::player
