// Counts the actions of the player with the goalie bit.
#include "analysis/play/goalkeeping.h"

#include <algorithm>

#include "analysis/play/pitch_areas.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

// Sum of the goalie's positions while the ball is near.
struct PositionSum {
  Vec2 sum;
  int count = 0;
};

void add_actions(const gamelog::MatchRecord& record, std::size_t entry, bool holds_ball,
                 Goalkeeping& goalie) {
  const std::size_t before = entry - gamelog::kSlots;
  const std::uint32_t state = record.players.state[entry];
  if ((state & gamelog::kStateCatch) != 0) {
    // Without counters (versions 1 and 2) punches cannot be distinguished from other failures.
    const bool counted = record.version >= gamelog::RcgVersion::kV3
                             ? has_executed(record, gamelog::Counter::kCatch, entry)
                             : has_caught(state);
    goalie.catches += counted && has_caught(state);
    goalie.punches += counted && !has_caught(state);
    goalie.failed_catches += !counted;
  }

  if (holds_ball) {
    constexpr std::size_t kMove = base::index(gamelog::Counter::kMove);
    const auto& counters = record.players.counters;
    goalie.moves_after_catch += std::max(0, counters[entry][kMove] - counters[before][kMove]);
  }
}

void add_position(const Flow& flow, std::size_t frame, std::size_t slot, PositionSum& positions,
                  Goalkeeping& goalie) {
  const double sign = attack_sign(slot);
  const Vec2 seen = Vec2(flow.record->players.position[entry_of(frame, slot)]) * sign;
  const double rush = soccer::distance(seen, {-soccer::kHalfLength, 0.0});
  goalie.furthest_rush = std::max(goalie.furthest_rush, rush);
  if (flow.record->ball_position[frame].x * sign < -kThirdBorder) {
    positions.sum += seen;
    ++positions.count;
  }
}

}  // namespace

PerTeam<Goalkeeping> measure_goalkeeping(const Flow& flow, const std::vector<Shot>& shots) {
  const gamelog::MatchRecord& record = *flow.record;
  PerTeam<Goalkeeping> goalies;
  PerTeam<PositionSum> positions;
  PerTeam<bool> holds = {};

  for (std::size_t i = 1; i < record.frames(); ++i) {
    const bool free_kick = soccer::without_side(record.mode[i]) == soccer::PlayMode::kFreeKickLeft;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      const std::size_t team = team_of(slot);
      if (!is_goalie(record, entry) || !gamelog::is_enabled(record, entry)) continue;
      if (flow.phase[i] == Phase::kPenalty || record.time[i] < record.time[i - 1]) continue;

      add_actions(record, entry, holds[team], goalies[team]);
      holds[team] = free_kick && (holds[team] || has_caught(record.players.state[entry]));
      if (flow.is_live(i)) add_position(flow, i, slot, positions[team], goalies[team]);
    }
  }

  for (std::size_t team = 0; team < 2; ++team) {
    if (positions[team].count > 0) {
      goalies[team].mean_position = positions[team].sum / positions[team].count;
    }
  }

  for (const Shot& shot : shots) {
    Goalkeeping& goalie = goalies[1 - team_of(shot.slot)];
    goalie.saves += shot.outcome == ShotOutcome::kSaved;
    goalie.conceded_on_target += shot.outcome == ShotOutcome::kGoal && shot.on_target;
  }
  return goalies;
}

}  // namespace cls::analysis
