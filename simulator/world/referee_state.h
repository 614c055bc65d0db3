// State of each referee rule between cycles.
#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "simulator/world/player.h"

namespace cls::simulator {

struct TimeState {
  int finished_halves = 0;
};

struct BallStuckState {
  Vec2 reference;
  int counter = 0;
};

struct OffsideState {
  bool has_kick = false;
  int kick_time = 0;
  int kick_stoppage = 0;
  double kick_acceleration = 0.0;
  Side kicker_side = Side::kNeutral;
  std::array<std::optional<Vec2>, soccer::kPlayersOnPitch> marks;  ///< offside line position if set
  Vec2 offense_position;
  int counter = 0;
};

struct FreeKickState {
  bool taken = false;
  Slot taker = kNoPlayer;
  int taker_dashes = 0;
  int goal_kicks = 0;
  int timer = -1;
  int counter = 0;
};

struct TouchState {
  Slot toucher = kNoPlayer;
  int touch_time = -1;
  double touch_acceleration = 0.0;
  Vec2 previous_ball;
  bool indirect = false;
  Slot indirect_kicker = kNoPlayer;
  int counter = 0;
};

struct CatchState {
  Slot passer = kNoPlayer;
  Slot passer_before = kNoPlayer;
  int pass_time = -1;
  std::array<bool, 2> touched = {};  ///< by team, since the last analyze()
  int counter = 0;
};

struct FoulState {
  int counter = 0;
};

struct IllegalDefenseState {
  int kick_time = -1;
  Side kicker_side = Side::kNeutral;
  std::array<int, 2> counters = {};
  int counter = 0;
};

struct KeepawayState {
  /// Value of `possession` in the step in which the takers ended an episode by winning the ball.
  static constexpr int kWonByTakers = -1;

  int keepers = 0;
  int takers = 0;
  int possession = 0;  ///< cycles in which a taker could kick the ball
  int episode = 0;

  /// Valid in the step in which an episode ended: false if the ball left the area.
  bool won_by_takers() const { return possession == kWonByTakers; }
};

struct PenaltyState {
  bool started = false;
  bool decided = false;
  Side goal_side = Side::kNeutral;
  Side taker_side = Side::kNeutral;
  Slot last_taker = kNoPlayer;
  std::array<std::bitset<soccer::kPlayersPerTeam + 1>, 2> has_kicked;  ///< by uniform number
  int kicks = 0;
  int timer = 0;
  Vec2 previous_ball;
};

/// One member per rule, in the order in which rules are called (docs/spec/simulation-model.md 2.2).
struct RefereeState {
  TimeState time;
  BallStuckState ball_stuck;
  OffsideState offside;
  FreeKickState free_kick;
  TouchState touch;
  CatchState catch_ball;
  FoulState foul;
  IllegalDefenseState illegal_defense;
  KeepawayState keepaway;
  PenaltyState penalty;
};

/// Counters of the automatic kick-off and end (docs/spec/simulation-model.md 9.16).
struct AutoMode {
  int kick_off_wait = 0;
  int connect_wait = 0;
  int game_over_wait = 0;
  bool ended = false;
};

}  // namespace cls::simulator
