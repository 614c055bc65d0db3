// Means, clouds, heat maps.
#include "analysis/measures/positions.h"

#include <algorithm>

#include "analysis/measures/team_shape.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr int kShapeStep = 10;

std::size_t heat_cell(gamelog::Point position) {
  const double column = (position.x + soccer::kHalfLength) / 5.0;
  const double row = (position.y + kHeatRows * 2.5) / 5.0;
  const auto clamped = [](double value, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(count) - 0.5));
  };
  return clamped(row, kHeatRows) * kHeatColumns + clamped(column, kHeatColumns);
}

struct Sums {
  int count = 0;
  Vec2 sum;
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  void add(Vec2 p) {
    ++count;
    sum += p;
    xx += p.x * p.x;
    yy += p.y * p.y;
    xy += p.x * p.y;
  }
  Vec2 mean() const { return count == 0 ? Vec2{} : sum / count; }
  Cloud cloud() const {
    if (count == 0) return {};
    const Vec2 m = mean();
    return {count, m, xx / count - m.x * m.x, yy / count - m.y * m.y, xy / count - m.x * m.y};
  }
};

struct PlayerSums {
  Sums all;
  Sums own_ball;
  Sums opponent_ball;
};

}  // namespace

PositionStats positions_of(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  PositionStats result;
  PerPlayer<PlayerSums> sums;
  PerTeam<ShapeMeter> shapes;
  int live = 0;
  for (std::size_t i = 0; i < record.frames(); ++i) {
    if (!flow.is_live(i)) continue;
    ++result.ball[heat_cell(record.ball_position[i])];
    const std::int8_t owner = flow.owner[i];
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      if (!gamelog::is_enabled(record, entry)) continue;
      const gamelog::Point at = record.players.position[entry];
      const Vec2 seen = Vec2(at) * attack_sign(slot);
      sums[slot].all.add(seen);
      ++result.players[slot].heat[heat_cell(at)];
      if (owner == kNobody) continue;
      const bool own = same_team(static_cast<std::size_t>(owner), slot);
      (own ? sums[slot].own_ball : sums[slot].opponent_ball).add(seen);
    }
    if (live++ % kShapeStep == 0) {
      for (std::size_t team = 0; team < 2; ++team) shapes[team].add(record, i, team);
    }
  }
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    result.players[slot].all = sums[slot].all.cloud();
    result.players[slot].mean_own_ball = sums[slot].own_ball.mean();
    result.players[slot].mean_opponent_ball = sums[slot].opponent_ball.mean();
  }
  for (std::size_t team = 0; team < 2; ++team) {
    std::vector<double> mean_x;
    for (std::size_t slot = team * gamelog::kSlots / 2; slot < (team + 1) * gamelog::kSlots / 2;
         ++slot) {
      const bool keeper = record.frames() > 0 && is_goalie(record, slot);
      if (sums[slot].all.count > 0 && !keeper) mean_x.push_back(sums[slot].all.mean().x);
    }
    result.teams[team] = shapes[team].shape();
    set_formation(mean_x, result.teams[team]);
  }
  return result;
}

}  // namespace cls::analysis
