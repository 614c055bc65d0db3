// Classes of steps: what happened to an object in a step.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "simulator/world/event.h"

namespace cls::simulator {

/// The most specific class applies: a player that dashed into another one collided.
enum class StepClass : std::uint8_t {
  kBallFree,  ///< no contact
  kBallStopped,
  kBallKick,
  kBallTackle,
  kBallCatch,
  kBallHeld,
  kBallCollision,
  kBallPost,
  kBallPlaced,  ///< by the referee or a trainer
  kBallHalfTime,
  kPlayerIdle,
  kPlayerBlocked,  ///< by a tackle or a foul
  kPlayerDash,
  kPlayerTurn,
  kPlayerKick,
  kPlayerTackle,
  kPlayerCatch,
  kPlayerMove,
  kPlayerCollision,
  kPlayerPost,
  kPlayerPlaced,  ///< by the referee (cleared from the ball, moved to the own half) or a trainer
  kPlayerHalfTime,
};
constexpr std::size_t kStepClassCount = static_cast<std::size_t>(StepClass::kPlayerHalfTime) + 1;

/// "ball_free", "player_dash", ...
std::string_view name(StepClass step_class);

/// True for contacts and placements, which magnify the rounding of a log.
bool magnifies_rounding(StepClass step_class);

/// `before` is the world before the commands, `after` the world after step().
StepClass ball_class(const World& before, const World& after);
StepClass player_class(const World& before, const World& after, Slot slot);

}  // namespace cls::simulator
