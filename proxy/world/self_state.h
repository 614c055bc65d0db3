// What an agent believes about itself.
#pragma once

#include "proxy/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"
#include "soccer/messages/sense_body.h"

namespace cls::proxy {

/// Positions in metres, velocities in metres per cycle (what the next step will add), own team
/// attacks +x. Velocity, stamina and counters come from sense_body, position and body from the
/// landmarks, carried over the cycles in between.
struct SelfState {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  soccer::Vec2 seen_position;  ///< where the last see put us; not advanced
  soccer::Vec2 seen_velocity;
  soccer::AngleDeg body;
  soccer::AngleDeg neck;          ///< relative to the body
  double position_deviation = 0;  ///< standard deviation of position, metres (per axis)
  double body_deviation = 0;      ///< standard deviation of body, degrees

  int pos_count = kNever;  ///< since localised: by landmarks or an own move command
  int seen_pos_count = kNever;
  int vel_count = kNever;
  int seen_vel_count = kNever;
  int body_count = kNever;  ///< since body and face were taken from landmarks

  double stamina = 0.0;
  double effort = 1.0;
  double recovery = 1.0;   ///< own reckoning: the server does not tell
  double capacity = -1.0;  ///< remaining stamina reserve; negative: unlimited

  soccer::CommandCounts counts;
  soccer::ViewWidth view_width = soccer::ViewWidth::kNormal;
  soccer::ViewQuality view_quality = soccer::ViewQuality::kHigh;
  double focus_distance = 0.0;       ///< metres
  soccer::AngleDeg focus_direction;  ///< relative to the face

  soccer::ArmState arm;
  soccer::AngleDeg point_direction;  ///< global direction of the own arm
  int point_count = kNever;          ///< since the own arm was pointed; kNever when it hangs
  soccer::Side attention_side = soccer::Side::kNeutral;
  int attention_unum = 0;

  int tackle_count = 0;       ///< tackles carried out so far
  int tackle_expires_in = 0;  ///< cycles we stay on the ground after a tackle
  int foul_charged = 0;       ///< cycles we stay on the ground after being fouled
  bool collided_with_ball = false;
  bool collided_with_player = false;
  bool collided_with_post = false;
  soccer::Card card = soccer::Card::kNone;
  int type_id = 0;
  bool kicked = false;  ///< the last step carried out a kick of ours
  int catch_time = 0;   ///< cycle of the last own catch command that was carried out; 0: none
  int catch_ban = 0;    ///< cycles until the next catch may be tried

  // Derived when the world model is completed for a decision.
  bool kickable = false;
  double kick_rate = 0.0001;  ///< ball acceleration per unit of kick power, here and now
  double catch_probability = 0.0;
  double tackle_probability = 0.0;
  double foul_probability = 0.0;
  double safety_dash_power = 0.0;  ///< largest power that keeps recovery from falling

  soccer::AngleDeg face() const { return body + neck; }
  bool frozen() const { return tackle_expires_in > 0 || foul_charged > 0; }
  bool tackling() const { return tackle_expires_in > 0; }
  bool position_valid() const { return pos_count < kSelfPositionAgeLimit; }
  bool velocity_valid() const { return vel_count < kSelfVelocityAgeLimit; }
  bool face_valid() const { return body_count < kSelfFaceAgeLimit; }
};

}  // namespace cls::proxy
