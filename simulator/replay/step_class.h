// What happened to ball and players in a step, by which a replay sorts its steps.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "simulator/world/event.h"

namespace cls::simulator {

/// Most specific last: a player that dashed into another one collided.
enum class StepClass : std::uint8_t {
  kBallFree,  ///< nobody touched it
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
  kPlayerPlaced,  ///< by the referee (cleared from the ball, put into the own half) or a trainer
  kPlayerHalfTime,
};
constexpr std::size_t kStepClassCount = static_cast<std::size_t>(StepClass::kPlayerHalfTime) + 1;

/// "ball_free", "player_dash", ...
std::string_view name(StepClass step_class);

/// Contacts and places next to something magnify the rounding of a record.
bool magnifies_rounding(StepClass step_class);

/// `before` is the world ahead of the commands, `after` that of step(); one step lies between.
StepClass ball_class(const World& before, const World& after);
StepClass player_class(const World& before, const World& after, Slot slot);

}  // namespace cls::simulator
