// Play modes: numbers on the wire and in logs, names, sides, and how the clock runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "soccer/side.h"

namespace cls::soccer {

/// Numbers of the monitor protocol and rcg (rcssserver 19). In kick_off, kick_in, free_kick,
/// corner_kick, goal_kick, goal and penalty modes the side is the one that benefits; in offside,
/// foul, back_pass, catch_fault, free_kick_fault and illegal_defense it is the side at fault.
enum class PlayMode : std::uint8_t {
  kNull = 0,
  kBeforeKickOff = 1,
  kTimeOver = 2,
  kPlayOn = 3,
  kKickOffLeft = 4,
  kKickOffRight = 5,
  kKickInLeft = 6,
  kKickInRight = 7,
  kFreeKickLeft = 8,
  kFreeKickRight = 9,
  kCornerKickLeft = 10,
  kCornerKickRight = 11,
  kGoalKickLeft = 12,
  kGoalKickRight = 13,
  kGoalLeft = 14,
  kGoalRight = 15,
  kDropBall = 16,
  kOffsideLeft = 17,
  kOffsideRight = 18,
  kPenaltyKickLeft = 19,
  kPenaltyKickRight = 20,
  kFirstHalfOver = 21,
  kPause = 22,
  kHumanJudge = 23,
  kFoulChargeLeft = 24,
  kFoulChargeRight = 25,
  kFoulPushLeft = 26,
  kFoulPushRight = 27,
  kFoulMultipleAttackLeft = 28,
  kFoulMultipleAttackRight = 29,
  kFoulBallOutLeft = 30,
  kFoulBallOutRight = 31,
  kBackPassLeft = 32,
  kBackPassRight = 33,
  kFreeKickFaultLeft = 34,
  kFreeKickFaultRight = 35,
  kCatchFaultLeft = 36,
  kCatchFaultRight = 37,
  kIndirectFreeKickLeft = 38,
  kIndirectFreeKickRight = 39,
  kPenaltySetupLeft = 40,
  kPenaltySetupRight = 41,
  kPenaltyReadyLeft = 42,
  kPenaltyReadyRight = 43,
  kPenaltyTakenLeft = 44,
  kPenaltyTakenRight = 45,
  kPenaltyMissLeft = 46,
  kPenaltyMissRight = 47,
  kPenaltyScoreLeft = 48,
  kPenaltyScoreRight = 49,
  kIllegalDefenseLeft = 50,
  kIllegalDefenseRight = 51,
};

constexpr int kPlayModeCount = 52;

/// How a simulation step treats the world in a mode (docs/spec/simulation-model.md 2.1).
enum class ModeClass : std::uint8_t {
  kWaiting,  ///< before_kick_off: players only turn, stopped clock
  kStopped,  ///< after a goal or an offence: full motion, stopped clock
  kRunning,  ///< everything else: full motion, the clock runs
  kOver,     ///< time_over: nothing moves
};

/// The name in referee messages and rcg; empty for kNull.
std::string_view name(PlayMode mode);

/// The mode of a referee message; nothing for other text.
std::optional<PlayMode> parse_play_mode(std::string_view name);

/// The side of a mode; kNeutral for modes without a side.
Side side(PlayMode mode);

/// The variant of `mode` for `side`, which must not be neutral; `mode` must have a side. By
/// convention callers pass the left variant: `for_side(PlayMode::kKickInLeft, side)`.
PlayMode for_side(PlayMode mode, Side side);

/// The left variant of a mode with a side, other modes unchanged.
inline PlayMode without_side(PlayMode mode) {
  return side(mode) == Side::kNeutral ? mode : for_side(mode, Side::kLeft);
}

ModeClass mode_class(PlayMode mode);

/// True for the modes penalty_setup, _ready, _taken, _miss and _score of either side.
bool is_penalty_mode(PlayMode mode);

/// True for kick_off, kick_in, free_kick, indirect_free_kick, corner_kick and goal_kick.
bool is_set_play(PlayMode mode);

}  // namespace cls::soccer
