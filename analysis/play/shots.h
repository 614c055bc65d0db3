// Shots with their outcomes, and goals with their scorers.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/play/flow.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::analysis {

enum class ShotOutcome : std::uint8_t {
  kGoal,
  kSaved,    ///< by the goalie
  kBlocked,  ///< by another opponent
  kWide,     ///< off the pitch
  kPost,
  kOther,  ///< play was stopped, or the ball stopped
};
std::string_view name(ShotOutcome outcome);

/// A touch that sends the ball toward the goal, fast enough to get there
/// (docs/spec/match-statistics.md 3.3).
struct Shot {
  std::uint32_t touch = 0;  ///< index into Flow::touches
  std::int8_t slot = kNoPlayer;
  bool on_target = false;  ///< would cross the line between the posts
  ShotOutcome outcome = ShotOutcome::kOther;
  double distance = 0.0;  ///< meters from the contact point to the goal's center
  double speed = 0.0;     ///< meters per cycle
  double goal_y = 0.0;    ///< y where it would cross the goal line, as the team sees the pitch
  double cycles = 0.0;    ///< until it crosses the line
};

/// In the order of the match. A touch followed by one of a teammate, or of the same player soon
/// after, is a pass or dribble instead.
std::vector<Shot> find_shots(const Flow& flow);

/// True if a touch by `slot` is a shot, assuming that the ball is not touched afterwards; fills
/// `shot` except the outcome.
bool heads_for_goal(const gamelog::MatchRecord& record, const Touch& touch, std::size_t slot,
                    Shot& shot);

/// An increase of the score.
struct Goal {
  std::uint32_t frame = 0;  ///< first with the new score, otherwise the last one
  std::int32_t cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< scoring side
  std::int8_t scorer = kNoPlayer;              ///< slot; a player of the other side for an own goal
  bool own_goal = false;
  std::int32_t shot = -1;  ///< index into the shots; -1: none
};

/// Goals except those of a shoot-out (docs/spec/match-statistics.md 3.4). Shots that led to one
/// have the outcome kGoal.
std::vector<Goal> find_goals(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
