// What perception remembers between messages to follow the agent itself and the ball.
#pragma once

#include <array>
#include <optional>

#include "proxy/world/gaussian.h"
#include "soccer/commands/player_command.h"
#include "soccer/geometry.h"

namespace cls::proxy {

/// What the agent sent for the cycle that is running out; one of each kind at most.
struct SentCommands {
  std::optional<soccer::Turn> turn;
  std::optional<soccer::Dash> dash;
  std::optional<soccer::Kick> kick;
  std::optional<soccer::Tackle> tackle;
  std::optional<soccer::Catch> catches;
  std::optional<soccer::Move> move;
  std::optional<soccer::TurnNeck> turn_neck;
  std::optional<soccer::PointTo> point_to;
  bool leg_dash = false;  ///< dashes of single legs: they turn the body in a way not followed here
};

/// Belief about (x, y, body in degrees), and what was sent but not yet confirmed.
struct SelfTracker {
  bool located = false;  ///< the pose holds
  Gaussian<3> pose;
  double heading_variance = 0.0;      ///< of the direction of the own velocity, square degrees
  double heading_follows_body = 0.0;  ///< degrees the velocity's direction turns per degree the
                                      ///< body is corrected by
  SentCommands sent;
};

/// Belief about the ball's (x, y, vx, vy).
struct BallTracker {
  bool tracked = false;
  bool pushed = false;  ///< the present look contradicted the ball's course: somebody touched it
  Gaussian<4> state;
};

}  // namespace cls::proxy
