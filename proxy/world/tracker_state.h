// What perception remembers between messages to follow the agent itself and the ball.
#pragma once

#include <array>
#include <optional>

#include "soccer/geometry.h"
#include "soccer/protocol/player_command.h"

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
};

/// Belief about (x, y, body in degrees) as a Gaussian, and what was sent but not yet confirmed.
struct SelfTracker {
  bool located = false;  ///< the Gaussian holds
  std::array<double, 9> covariance{};
  SentCommands sent;
};

/// Belief about the ball's (x, y, vx, vy) as a Gaussian around BallState's values.
struct BallTracker {
  std::array<double, 16> covariance{};
};

}  // namespace cls::proxy
