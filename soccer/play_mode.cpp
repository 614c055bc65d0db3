// Play modes: names and classes.
#include "soccer/play_mode.h"

#include <cassert>

#include "base/text/enum_names.h"

namespace cls::soccer {
namespace {

constexpr auto kNames = base::enum_names<PlayMode>(
    "", "before_kick_off", "time_over", "play_on", "kick_off_l", "kick_off_r", "kick_in_l",
    "kick_in_r", "free_kick_l", "free_kick_r", "corner_kick_l", "corner_kick_r", "goal_kick_l",
    "goal_kick_r", "goal_l", "goal_r", "drop_ball", "offside_l", "offside_r", "penalty_kick_l",
    "penalty_kick_r", "first_half_over", "pause", "human_judge", "foul_charge_l", "foul_charge_r",
    "foul_push_l", "foul_push_r", "foul_multiple_attack_l", "foul_multiple_attack_r",
    "foul_ballout_l", "foul_ballout_r", "back_pass_l", "back_pass_r", "free_kick_fault_l",
    "free_kick_fault_r", "catch_fault_l", "catch_fault_r", "indirect_free_kick_l",
    "indirect_free_kick_r", "penalty_setup_l", "penalty_setup_r", "penalty_ready_l",
    "penalty_ready_r", "penalty_taken_l", "penalty_taken_r", "penalty_miss_l", "penalty_miss_r",
    "penalty_score_l", "penalty_score_r", "illegal_defense_l", "illegal_defense_r");
static_assert(kNames.texts.size() == kPlayModeCount);

int index_of(PlayMode mode) { return static_cast<int>(mode); }

}  // namespace

std::string_view name(PlayMode mode) { return kNames.name(mode); }

std::optional<PlayMode> parse_play_mode(std::string_view name) {
  return name.empty() ? std::nullopt : kNames.parse(name);
}

Side side(PlayMode mode) {
  const std::string_view text = name(mode);
  if (text.size() < 2 || text[text.size() - 2] != '_') return Side::kNeutral;

  if (text.back() == 'l') return Side::kLeft;
  if (text.back() == 'r') return Side::kRight;
  return Side::kNeutral;
}

PlayMode for_side(PlayMode mode, Side wanted) {
  const Side own = side(mode);
  assert(own != Side::kNeutral && wanted != Side::kNeutral);
  const int left = own == Side::kLeft ? index_of(mode) : index_of(mode) - 1;
  return static_cast<PlayMode>(wanted == Side::kLeft ? left : left + 1);
}

ModeClass mode_class(PlayMode mode) {
  switch (without_side(mode)) {
    case PlayMode::kBeforeKickOff:
      return ModeClass::kWaiting;
    case PlayMode::kTimeOver:
      return ModeClass::kOver;
    case PlayMode::kGoalLeft:
    case PlayMode::kOffsideLeft:
    case PlayMode::kFoulChargeLeft:
    case PlayMode::kFoulPushLeft:
    case PlayMode::kBackPassLeft:
    case PlayMode::kFreeKickFaultLeft:
    case PlayMode::kCatchFaultLeft:
    case PlayMode::kIllegalDefenseLeft:
      return ModeClass::kStopped;
    default:
      return ModeClass::kRunning;
  }
}

bool is_penalty_mode(PlayMode mode) {
  return mode >= PlayMode::kPenaltySetupLeft && mode <= PlayMode::kPenaltyScoreRight;
}

bool is_set_play(PlayMode mode) {
  return (mode >= PlayMode::kKickOffLeft && mode <= PlayMode::kGoalKickRight) ||
         mode == PlayMode::kIndirectFreeKickLeft || mode == PlayMode::kIndirectFreeKickRight;
}

}  // namespace cls::soccer
