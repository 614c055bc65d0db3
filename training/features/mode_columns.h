// The kind of play mode as flags, one of which is set unless the ball is in play.
#pragma once

#include <array>

#include "soccer/play_mode.h"
#include "training/features/feature_writer.h"
#include "training/scene/column.h"

namespace cls::training {

/// Of a play mode: which kind of restart, and whose.
struct ModeKind {
  static constexpr std::array kNames = {"mode_kick_off",    "mode_kick_in",   "mode_free_kick",
                                        "mode_corner_kick", "mode_goal_kick", "mode_penalty",
                                        "mode_stopped"};
  std::size_t index = kNames.size();  ///< beyond the names: play is on
  soccer::Side side = soccer::Side::kNeutral;
};

inline ModeKind kind_of(soccer::PlayMode mode) {
  using soccer::PlayMode;
  const soccer::Side side = soccer::side(mode);
  if (soccer::is_penalty_mode(mode)) return {5, side};
  switch (soccer::without_side(mode)) {
    case PlayMode::kPlayOn:
      return {};
    case PlayMode::kBeforeKickOff:
    case PlayMode::kKickOffLeft:
      return {0, side};
    case PlayMode::kKickInLeft:
      return {1, side};
    case PlayMode::kFreeKickLeft:
    case PlayMode::kIndirectFreeKickLeft:
      return {2, side};
    case PlayMode::kCornerKickLeft:
      return {3, side};
    case PlayMode::kGoalKickLeft:
      return {4, side};
    default:
      return {6, side};
  }
}

inline void append_mode(Columns& out) {
  for (const char* name : ModeKind::kNames) append(out, name, {""}, "0/1");
  append(out, "mode_own", {""});  // 1: of the own team, -1: of the other, 0: of none
}

inline void add_mode(FeatureWriter& out, soccer::PlayMode mode, soccer::Side own) {
  const ModeKind kind = kind_of(mode);
  for (std::size_t i = 0; i < ModeKind::kNames.size(); ++i) out.flag(i == kind.index);
  out.value(soccer::sign(kind.side) * soccer::sign(own));
}

}  // namespace cls::training
