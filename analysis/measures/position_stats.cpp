// Computes mean positions, covariances, heat maps and team shapes.
#include "analysis/measures/position_stats.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr std::size_t kDefenders = 3;
constexpr std::size_t kMinPlayers = 3;
constexpr double kWideGap = 5.0;  // gap in meters that makes a fourth line

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

// Of the field players that were there.
std::vector<double> mean_x_of(const gamelog::MatchRecord& record, const PerPlayer<PlayerSums>& sums,
                              std::size_t team) {
  std::vector<double> mean_x;
  for (const std::size_t slot : kTeamSlots[team]) {
    if (sums[slot].all.count == 0 || was_goalie(record, slot)) continue;
    mean_x.push_back(sums[slot].all.mean().x);
  }
  return mean_x;
}

}  // namespace

double hull_area(std::vector<Vec2> points) {
  if (points.size() < 3) return 0.0;

  std::ranges::sort(points, {}, [](Vec2 p) { return std::tuple(p.x, p.y); });

  std::vector<Vec2> hull;
  const auto extend = [&hull](Vec2 p, std::size_t start) {
    while (hull.size() >= start + 2 &&
           soccer::cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };

  for (const Vec2 p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, lower);

  double twice = 0.0;
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) twice += soccer::cross(hull[i], hull[i + 1]);
  return twice / 2;
}

void ShapeAccumulator::add(const gamelog::MatchRecord& record, std::size_t frame,
                           std::size_t team) {
  std::vector<Vec2> players;
  Vec2 center;
  for (const std::size_t slot : kTeamSlots[team]) {
    const std::size_t entry = entry_of(frame, slot);
    if (!gamelog::is_enabled(record, entry) || is_goalie(record, entry)) continue;
    players.push_back(Vec2(record.players.position[entry]) * attack_sign(slot));
    center += players.back();
  }

  if (players.size() < kMinPlayers) return;
  const auto count = static_cast<double>(players.size());
  center = center / count;

  double distance_sum = 0.0;
  for (const Vec2 p : players) distance_sum += soccer::distance(p, center);
  const auto [top, bottom] = std::ranges::minmax(players, {}, &Vec2::y);
  std::ranges::sort(players, {}, &Vec2::x);

  ++count_;
  sum_.length += players.back().x - players.front().x;
  sum_.width += bottom.y - top.y;
  sum_.compactness += distance_sum / count;
  sum_.defense_x += (players[0].x + players[1].x + players[2].x) / kDefenders;
  sum_.hull_area += hull_area(std::move(players));
}

TeamShape ShapeAccumulator::shape() const {
  if (count_ == 0) return {};
  return {.length = sum_.length / count_,
          .width = sum_.width / count_,
          .hull_area = sum_.hull_area / count_,
          .compactness = sum_.compactness / count_,
          .defense_x = sum_.defense_x / count_};
}

void set_formation(std::vector<double> mean_x, TeamShape& shape) {
  if (mean_x.size() < 2 * kMinPlayers) return;

  std::ranges::sort(mean_x);
  std::vector<std::size_t> gaps(mean_x.size() - 1);
  std::iota(gaps.begin(), gaps.end(), std::size_t{0});
  const auto width = [&](std::size_t i) { return mean_x[i + 1] - mean_x[i]; };
  std::ranges::sort(gaps, std::greater(), width);

  const bool four_lines = width(gaps[2]) >= kWideGap;
  gaps.resize(four_lines ? 3 : 2);
  std::ranges::sort(gaps);

  std::vector<double> lines;
  std::size_t first = 0;
  gaps.push_back(mean_x.size() - 1);
  for (const std::size_t last : gaps) {
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) sum += mean_x[i];
    lines.push_back(sum / static_cast<double>(last + 1 - first));
    shape.formation += (first == 0 ? "" : "-") + std::to_string(last + 1 - first);
    first = last + 1;
  }

  shape.line_distance = (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
}

PositionStats measure_positions(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  PositionStats result;
  PerPlayer<PlayerSums> sums;
  PerTeam<ShapeAccumulator> shapes;
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

      if (owner == kNoPlayer) continue;
      (same_team(owner, slot) ? sums[slot].own_ball : sums[slot].opponent_ball).add(seen);
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
    result.teams[team] = shapes[team].shape();
    set_formation(mean_x_of(record, sums, team), result.teams[team]);
  }
  return result;
}

}  // namespace cls::analysis
