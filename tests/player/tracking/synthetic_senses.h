// Synthetic sense_body and see messages of a simple world, by the server's formulas.
#pragma once

#include <vector>

#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/parameters/player_type.h"
#include "soccer/random.h"
#include "soccer/side.h"

namespace cls::tests {

using soccer::Side;
using soccer::Vec2;

/// A player in server coordinates (never mirrored).
struct TruePlayer {
  Side side = Side::kLeft;
  int unum = 1;
  bool goalie = false;
  Vec2 position;
  Vec2 velocity;
  double body = 0.0;
  double neck = 0.0;
  bool kicked = false;
  bool tackling = false;
};

struct TrueWorld {
  int time = 0;
  TruePlayer self;
  soccer::ViewWidth width = soccer::ViewWidth::kNormal;
  double focus_distance = 0.0;
  double focus_direction = 0.0;
  Vec2 ball;
  Vec2 ball_velocity;
  std::vector<TruePlayer> others;
  double unum_far = 20.0;                    ///< maximum distance at which numbers are visible
  soccer::RandomStream* gaussian = nullptr;  ///< draws of the Gaussian model; null: quantized
};

/// The see message (docs/spec/simulation-model.md 7.3 to 7.8, version 18 or 19) without
/// other random draws: details that the server shows with some probability are shown up to
/// `unum_far`.
soccer::See see_of(const TrueWorld& world);

/// The sense_body message with speed, direction and neck rounded as in the server.
soccer::SenseBody sense_of(const TrueWorld& world);

constexpr const char* kLeftTeam = "Lefties";
constexpr const char* kRightTeam = "Righties";

}  // namespace cls::tests
