// State of a player: body, stamina, commands of the cycle, view, hearing and contacts.
#pragma once

#include <array>
#include <cstdint>

#include "gamelog/record/frame.h"
#include "soccer/geometry.h"
#include "soccer/protocol/view_mode.h"
#include "soccer/side.h"

namespace cls::simulator {

using soccer::kNoPlayer;
using soccer::Side;
using soccer::Vec2;

/// Index of a player in arrays of 22 (soccer::slot_of), or kNoPlayer.
using Slot = int;

/// Bits of a player's state as logs and monitors show them (docs/spec/simulation-model.md 12.1).
namespace state {
constexpr std::uint32_t kStand = 0x1;
constexpr std::uint32_t kKick = 0x2;
constexpr std::uint32_t kKickFault = 0x4;
constexpr std::uint32_t kGoalie = 0x8;
constexpr std::uint32_t kCatch = 0x10;
constexpr std::uint32_t kCatchFault = 0x20;
constexpr std::uint32_t kBallToPlayer = 0x40;
constexpr std::uint32_t kDiscard = 0x100;
constexpr std::uint32_t kBallCollide = 0x400;
constexpr std::uint32_t kPlayerCollide = 0x800;
constexpr std::uint32_t kTackle = 0x1000;
constexpr std::uint32_t kTackleFault = 0x2000;
constexpr std::uint32_t kBackPass = 0x4000;
constexpr std::uint32_t kFreeKickFault = 0x8000;
constexpr std::uint32_t kPostCollide = 0x10000;
constexpr std::uint32_t kFoulCharged = 0x20000;
constexpr std::uint32_t kYellowCard = 0x40000;
constexpr std::uint32_t kRedCard = 0x80000;
constexpr std::uint32_t kIllegalDefense = 0x100000;
}  // namespace state

/// Executed commands (docs/spec/simulation-model.md 12.3); `kick` counts only kicks that reached
/// the ball.
using Counters = gamelog::CommandCounts;

/// The command of one leg in this cycle (docs/spec/simulation-model.md 4.1). Only dashes take
/// effect later, in the step.
struct Leg {
  bool commanded = false;
  bool dashes = false;
  double power = 0.0;
  double direction = 0.0;  ///< degrees, relative to the body
};

struct Stamina {
  double value = 0.0;
  double effort = 0.0;
  double recovery = 0.0;
  double capacity = 0.0;
};

/// The pointing arm (docs/spec/simulation-model.md 4.12). `age` counts cycles since the last
/// accepted command.
struct Arm {
  Vec2 target;
  int age = 0;
};

/// View mode and focus (docs/spec/simulation-model.md 4.10, 4.11, 7.2).
struct View {
  soccer::ViewWidth width = soccer::ViewWidth::kNormal;
  soccer::ViewQuality quality = soccer::ViewQuality::kHigh;
  bool synchronous = false;      ///< synch_see; cannot be switched off
  bool gaussian = false;         ///< gaussian_see; cannot be switched off
  double focus_distance = 0.0;   ///< meters
  double focus_direction = 0.0;  ///< radians, relative to the face
};

/// Full width of the view cone in radians; `visible_angle` is the parameter, in degrees.
double view_cone(const View& view, double visible_angle);

/// Hearing modes and capacity (docs/spec/simulation-model.md 8.2, 8.5). Arrays are indexed by the
/// speaker's side: 0 left, 1 right.
struct Ears {
  std::array<bool, 2> complete = {true, true};
  std::array<bool, 2> partial = {false, false};
  int teammate_capacity = 0;
  int opponent_capacity = 0;
};

/// Collisions since the last sense_body; the sender of sense_body clears them.
struct Contacts {
  bool ball = false;
  bool player = false;
  bool post = false;
};

/// Angles are in radians: `body` in pitch coordinates, `neck` relative to the body. Commands set
/// the pending angles; a step commits them.
struct Player {
  Side side = Side::kLeft;
  int unum = 0;

  bool joined = false;   ///< a client has, or had, this player
  bool enabled = false;  ///< on the pitch; otherwise on the bench, untouched by the simulation
  bool goalie = false;
  int client_version = 3;
  int type = 0;
  bool substituted = false;  ///< its type was assigned by a coach or at the kick-off

  Arm arm;  // here, because steps change it even on the bench

  Vec2 position;
  Vec2 velocity;
  Vec2 acceleration;
  double body = 0.0;
  double pending_body = 0.0;
  double neck = 0.0;
  double pending_neck = 0.0;

  std::uint32_t state = 0;  ///< bits of namespace `state`
  Stamina stamina;
  Counters counters;

  bool command_done = false;  ///< the body command of this cycle was executed
  bool turn_neck_done = false;
  std::array<Leg, 2> legs;  ///< left, right
  int kick_cycles = -1;     ///< >= 0: kicked recently (docs/spec/simulation-model.md 4.1)
  int dash_cycles = -1;
  int tackle_cycles = 0;  ///< > 0: blocked by its tackle
  int foul_cycles = 0;    ///< > 0: blocked by a foul it suffered
  int catch_ban = 0;
  int moves_since_catch = 0;

  View view;
  Ears ears;
  Slot attention = kNoPlayer;
  Contacts contacts;

  int cards = 0;
  int fouls = 0;

  bool has(std::uint32_t bit) const { return (state & bit) != 0; }
  Slot slot() const { return soccer::slot_of(side, unum); }
};

/// Direction of the face in pitch coordinates, in radians.
double face_direction(const Player& player);

/// Focus point of the view in pitch coordinates.
Vec2 focus_point(const Player& player);

}  // namespace cls::simulator
