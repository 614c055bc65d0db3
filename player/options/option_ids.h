// The options of a field player in open play, as numbers: the action set "options".
#pragma once

#include <array>
#include <string>

#include "player/behaviors/behaviors.h"

namespace cls::player {

/// Receivers are the other players of the team, by uniform number.
constexpr int kReceivers = soccer::kPlayersPerTeam - 1;
/// Directions on the pitch: I is 22.5 I - 180 degrees, 0 degrees is towards their goal line.
constexpr int kDribbleDirections = 16;
constexpr int kShiftDirections = 8;
constexpr std::array kShifts = {4.0, 10.0};  ///< of the home position, meters

/// The kinds of passes of the planner, in the order of the ids.
enum class PassKind : std::uint8_t { kFeet, kAhead, kThrough, kCross };
constexpr int kPassKinds = 4;

// Ids. A change of ids or meanings needs a new version of the action set.

/// What the agent does where there is nothing to choose, and basic_move() without the ball.
constexpr int kAutoOption = 0;
// With the ball.
constexpr int kShootOption = 1;
constexpr int kHoldOption = 2;
constexpr int kLayOffOption = 3;
constexpr int kClearOption = 4;
constexpr int kDribbleOption = 5;
constexpr int kPassOption = kDribbleOption + kDribbleDirections;
// Without it.
constexpr int kMoveOption = kPassOption + kReceivers * kPassKinds;
constexpr int kHomeOption = kMoveOption + static_cast<int>(MoveKind::kHome);
constexpr int kShiftedHomeOption = kHomeOption + 1;
constexpr int kOptionCount =
    kShiftedHomeOption + kShiftDirections * static_cast<int>(kShifts.size());

/// Options with a target that the planner's generators check: dribbles and passes.
constexpr int kTargetOptions = kMoveOption - kDribbleOption;

/// Of the receiver with that number among the others, from 0.
constexpr int pass_option(int receiver, PassKind kind) {
  return kPassOption + receiver * kPassKinds + static_cast<int>(kind);
}
constexpr int move_option(MoveKind kind) { return kMoveOption + static_cast<int>(kind); }

/// "pass_7_through"; `id` must exist.
std::string option_name(int id);

/// For readers, without the receiver: "through pass", "dribble -45 deg", "home 4 m at 90 deg".
/// `id` must exist.
std::string option_text(int id);

}  // namespace cls::player
