// What each rule of the referee remembers from cycle to cycle.
#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "simulator/world/player.h"

namespace cls::simulator {

struct TimeRule {
  int finished_halves = 0;
};

struct BallStuckRule {
  Vec2 reference;
  int counter = 0;
};

struct OffsideRule {
  bool has_kick = false;
  int kick_time = 0;
  int kick_stoppage = 0;
  double kick_acceleration = 0.0;
  Side kicker_side = Side::kNeutral;
  std::array<std::optional<Vec2>, soccer::kPlayersOnPitch> marks;  ///< set: would be offside
  Vec2 offence;
  int counter = 0;
};

struct FreeKickRule {
  bool taken = false;
  Slot taker = kNobody;
  int taker_dashes = 0;
  int goal_kicks = 0;
  int timer = -1;
  int counter = 0;
};

struct TouchRule {
  Slot toucher = kNobody;
  int touch_time = -1;
  double touch_acceleration = 0.0;
  Vec2 previous_ball;
  bool indirect = false;
  Slot indirect_kicker = kNobody;
  int counter = 0;
};

struct CatchRule {
  Slot passer = kNobody;
  Slot passer_before = kNobody;
  int pass_time = -1;
  std::array<bool, 2> touched = {};  ///< by team, since the last analysis
  int counter = 0;
};

struct FoulRule {
  int counter = 0;
};

struct IllegalDefenseRule {
  int kick_time = -1;
  Side kicker_side = Side::kNeutral;
  std::array<int, 2> counters = {};
  int counter = 0;
};

struct KeepawayRule {
  int keepers = 0;
  int takers = 0;
  int possession = 0;
  int episode = 0;
};

struct PenaltyRule {
  bool started = false;
  bool decided = false;
  Side goal_side = Side::kNeutral;
  Side taker_side = Side::kNeutral;
  Slot last_taker = kNobody;
  std::array<std::bitset<soccer::kPlayersPerTeam + 1>, 2> has_kicked;  ///< by number
  int kicks = 0;
  int timer = 0;
  Vec2 previous_ball;
};

/// One member per rule, in the order in which rules are asked (2.2).
struct RefereeState {
  TimeRule time;
  BallStuckRule ball_stuck;
  OffsideRule offside;
  FreeKickRule free_kick;
  TouchRule touch;
  CatchRule catch_ball;
  FoulRule foul;
  IllegalDefenseRule illegal_defense;
  KeepawayRule keepaway;
  PenaltyRule penalty;
};

/// Counters of the automatic kick-off and end (9.16).
struct AutoMode {
  int kick_off_wait = 0;
  int connect_wait = 0;
  int game_over_wait = 0;
  bool ended = false;
};

}  // namespace cls::simulator
