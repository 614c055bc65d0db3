// One recorded moment of a match, as game logs hold it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gamelog/record/player_state.h"
#include "soccer/geometry.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::gamelog {

/// Commands carried out since the match began, in the order of the log.
struct CommandCounts {
  int kick = 0;
  int dash = 0;
  int turn = 0;
  int catches = 0;
  int move = 0;
  int turn_neck = 0;
  int change_view = 0;
  int say = 0;
  int tackle = 0;
  int pointto = 0;
  int attentionto = 0;
  int change_focus = 0;
};

/// A player slot, connected or not. Metres, degrees; the same frame for both teams.
struct PlayerFrame {
  std::uint32_t state = 0;  ///< bits of player_state.h
  int type = 0;
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  double body = 0.0;
  double neck = 0.0;  ///< relative to body
  std::optional<soccer::Vec2> pointing_at;
  bool high_quality = true;
  double view_width = 90.0;
  double focus_distance = 0.0;
  double focus_direction = 0.0;  ///< relative to body plus neck
  double stamina = 0.0;
  double effort = 0.0;
  double recovery = 0.0;
  double capacity = 0.0;                                 ///< -1: unlimited
  soccer::Side attention_side = soccer::Side::kNeutral;  ///< neutral: attention to nobody
  int attention_unum = 0;
  CommandCounts counts;
};

/// Name and score of a team. An empty name means that it never connected.
struct TeamFrame {
  std::string name;
  int score = 0;
  int penalty_scored = 0;
  int penalty_missed = 0;

  int penalties_taken() const { return penalty_scored + penalty_missed; }
  friend bool operator==(const TeamFrame&, const TeamFrame&) = default;
};

/// Left and right.
using TeamFrames = std::array<TeamFrame, 2>;

/// The whole pitch after one step.
struct Frame {
  int time = 0;
  int stopped = 0;  ///< cycles for which the clock has stood at `time`; only JSON logs show it
  soccer::PlayMode mode = soccer::PlayMode::kNull;
  TeamFrames teams;
  soccer::Vec2 ball_position;
  soccer::Vec2 ball_velocity;
  std::array<PlayerFrame, soccer::kPlayersOnPitch> players;  ///< by slot (soccer/side.h)
};

}  // namespace cls::gamelog
