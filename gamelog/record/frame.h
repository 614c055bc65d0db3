// One frame of a game log: ball, players, play mode and teams after one step.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "soccer/geometry.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::gamelog {

// Bits of a player's state (docs/spec/log-formats.md 1.3). Bits of actions last one frame, those of
// a tackle or a foul as long as the player cannot move, cards and kGoalie until the end. Versions 1
// to 3 have only the low sixteen bits.
constexpr std::uint32_t kStateEnabled = 0x1;  ///< if unset, the slot is not connected
constexpr std::uint32_t kStateKick = 0x2;
constexpr std::uint32_t kStateKickFailed = 0x4;  ///< always with kStateKick
constexpr std::uint32_t kStateGoalie = 0x8;
constexpr std::uint32_t kStateCatch = 0x10;
constexpr std::uint32_t kStateCatchFailed = 0x20;  ///< always with kStateCatch
constexpr std::uint32_t kStateBallContact = 0x40;
constexpr std::uint32_t kStateBallCollision = 0x400;
constexpr std::uint32_t kStateTackle = 0x1000;
constexpr std::uint32_t kStateTackleFailed = 0x2000;  ///< without kStateTackle: ball out of reach
constexpr std::uint32_t kStateBackPass = 0x4000;
constexpr std::uint32_t kStateFreeKickFault = 0x8000;
constexpr std::uint32_t kStateHitPost = 0x10000;
constexpr std::uint32_t kStateCharged = 0x20000;  ///< cannot move after being fouled
constexpr std::uint32_t kStateYellowCard = 0x40000;
constexpr std::uint32_t kStateRedCard = 0x80000;
constexpr std::uint32_t kStateIllegalDefense = 0x100000;

/// Numbers of commands executed since the start of the match, in the order of the log.
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

  bool operator==(const CommandCounts&) const = default;
};

/// A player slot, connected or not. Meters and degrees in one coordinate system for both teams.
struct PlayerFrame {
  std::uint32_t state = 0;  ///< bits kState... above
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
  soccer::Side attention_side = soccer::Side::kNeutral;  ///< neutral: no attention target
  int attention_unum = 0;
  CommandCounts counts;
};

/// Name and score of a team. The name is empty if the team never connected.
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
  int stopped = 0;  ///< cycles that the clock has been stopped at `time`; only JSON logs record it
  soccer::PlayMode mode = soccer::PlayMode::kNull;
  TeamFrames teams;
  soccer::Vec2 ball_position;
  soccer::Vec2 ball_velocity;
  std::optional<double> ball_height;  ///< meters; only the 2.5D server logs it
  std::array<PlayerFrame, soccer::kPlayersOnPitch> players;  ///< by slot (soccer/side.h)
};

}  // namespace cls::gamelog
