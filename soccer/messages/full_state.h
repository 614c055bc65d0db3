// The fullstate message: the full state without noise, for players with server::fullstate.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::soccer {

/// Global coordinates, degrees, no noise, never mirrored.
struct FullStatePlayer {
  Side side = Side::kLeft;
  int unum = 0;
  bool goalie = false;
  int type = 0;
  Vec2 position;
  Vec2 velocity;
  double body = 0.0;
  double neck = 0.0;  ///< relative to body
  bool pointing = false;
  double point_distance = 0.0;
  double point_direction_radians = 0.0;  ///< relative to body plus neck; radians in rcssserver
  double focus_distance = 0.0;           ///< version 18 and later
  double focus_direction = 0.0;
  double stamina = 0.0;
  double effort = 0.0;
  double recovery = 0.0;
  double capacity = 0.0;
  ActionMark mark = ActionMark::kNone;
  Card card = Card::kNone;
};

struct FullState {
  int time = 0;
  PlayMode mode = PlayMode::kBeforeKickOff;
  bool ball_caught = false;  ///< a goalie holds the ball; sent as mode goalie_catch_ball_X
  ViewQuality quality = ViewQuality::kHigh;
  ViewWidth width = ViewWidth::kNormal;
  CommandCounts counts;
  ArmState arm;
  int our_score = 0;
  int opponent_score = 0;
  Vec2 ball_position;
  Vec2 ball_velocity;
  std::vector<FullStatePlayer>
      players;  ///< enabled players including the receiver, left team first
};

/// Parses a fullstate of version 14 or later. Errors name the byte.
base::Result<void> parse(std::string_view message, FullState& out);

/// Appends the message for a client of `version` (8 to 19).
void format(const FullState& state, int version, std::string& out);

}  // namespace cls::soccer
