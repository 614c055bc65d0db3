// Shots, what became of them, and goals with their scorers.
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
  kSaved,    ///< by the goalkeeper
  kBlocked,  ///< by another opponent
  kWide,     ///< out of the field
  kPost,
  kOther,  ///< the play was stopped, or the ball ran out of speed
};
std::string_view name(ShotOutcome outcome);

/// A touch that sends the ball towards the goal, fast enough to get there (match-statistics 3.3).
struct Shot {
  std::uint32_t touch = 0;  ///< index into Flow::touches
  std::int8_t slot = kNobody;
  bool on_target = false;  ///< would cross the line between the posts
  ShotOutcome outcome = ShotOutcome::kOther;
  double distance = 0.0;  ///< metres from the contact to the goal's centre
  double speed = 0.0;     ///< metres per cycle
  double goal_y = 0.0;    ///< where it would cross the goal line, as its team sees it
  double cycles = 0.0;    ///< until then
};

/// In the order of the match. Touches that a team mate, or the same player soon after, takes over
/// are passes and dribbles, not shots.
std::vector<Shot> shots_of(const Flow& flow);

/// Which touch of a player of `slot` would be a shot if nobody touched the ball afterwards. The
/// outcome is left open.
bool heads_for_goal(const gamelog::MatchRecord& record, const Touch& touch, std::size_t slot,
                    Shot& shot);

/// A raised score.
struct Goal {
  std::uint32_t frame = 0;  ///< first with the new score; the last one for a score without a frame
  std::int32_t cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< whose score grew
  std::int8_t scorer = kNobody;                ///< slot; of the other side for an own goal
  bool own_goal = false;
  std::int32_t shot = -1;  ///< index into the shots; -1: no shot led to it
};

/// Goals of the game, not of a shoot-out (match-statistics 3.4). Shots that led to one are those
/// with the outcome kGoal.
std::vector<Goal> goals_of(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
