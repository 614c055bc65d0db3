// The sense_body message: the state of the player itself, every cycle.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/protocol/view_mode.h"
#include "soccer/side.h"

namespace cls::soccer {

/// Number of commands of each kind that the server has executed for a player.
struct CommandCounts {
  int kick = 0;
  int dash = 0;
  int turn = 0;
  int say = 0;
  int turn_neck = 0;
  int catches = 0;
  int move = 0;
  int change_view = 0;
  int change_focus = 0;  ///< version 18 and later
};

/// The pointing arm. The target is relative to position and body plus neck; 0 0 when idle.
struct ArmState {
  int movable_in = 0;  ///< cycles until the next pointto is accepted
  int expires_in = 0;  ///< cycles left of the current one
  double target_distance = 0.0;
  int target_direction = 0;  ///< degrees
  int count = 0;
};

/// One sense_body (docs/spec/server-protocol.md 4.2). Angles in whole degrees as sent.
struct SenseBody {
  int time = 0;
  ViewQuality quality = ViewQuality::kHigh;
  ViewWidth width = ViewWidth::kNormal;
  double stamina = 0.0;
  double effort = 0.0;
  double capacity = 0.0;
  double speed = 0.0;       ///< meters per cycle, in steps of 0.01
  int speed_direction = 0;  ///< relative to body plus neck, truncated
  int head_angle = 0;       ///< neck relative to body, truncated
  CommandCounts counts;
  ArmState arm;
  Side attention_side = Side::kNeutral;  ///< neutral: no attentionto
  int attention_unum = 0;
  int attention_count = 0;
  int tackle_expires_in = 0;  ///< cycles the player stays frozen, 0 = free
  int tackle_count = 0;
  bool collided_with_ball = false;
  bool collided_with_player = false;
  bool collided_with_post = false;
  int foul_charged = 0;  ///< cycles the player stays frozen after being fouled
  Card card = Card::kNone;
  bool has_focus_point = false;  ///< set by parse(); format() depends on the version only
  double focus_distance = 0.0;   ///< meters
  double focus_direction = 0.0;  ///< degrees, relative to the neck
};

/// Parses a sense_body of version 14 or later. Errors name the byte and leave `out` unspecified.
/// Does not allocate on success.
base::Result<void> parse(std::string_view message, SenseBody& out);

/// Appends the message for a client of `version` (8 to 19).
void format(const SenseBody& sense, int version, std::string& out);

}  // namespace cls::soccer
