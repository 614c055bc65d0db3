// Hulls, lines and distances of a team.
#include "analysis/measures/team_shape.h"

#include <algorithm>

#include "analysis/play/flow.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr std::size_t kDefenders = 3;
constexpr std::size_t kFewest = 3;
constexpr double kWideGap = 5.0;  // metres that make a fourth line

}  // namespace

double hull_area(std::vector<Vec2> points) {
  if (points.size() < 3) return 0.0;
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
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

void ShapeMeter::add(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team) {
  std::vector<Vec2> players;
  std::vector<double> xs;
  Vec2 centre;
  for (std::size_t slot = team * gamelog::kSlots / 2; slot < (team + 1) * gamelog::kSlots / 2;
       ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    if (!gamelog::is_enabled(record, entry) || is_goalie(record, entry)) continue;
    players.push_back(Vec2(record.players.position[entry]) * attack_sign(slot));
    xs.push_back(players.back().x);
    centre += players.back();
  }
  if (players.size() < kFewest) return;
  const auto count = static_cast<double>(players.size());
  centre = centre / count;
  double away = 0.0;
  double top = players[0].y;
  double bottom = players[0].y;
  for (const Vec2 p : players) {
    away += soccer::distance(p, centre);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  std::sort(xs.begin(), xs.end());
  ++count_;
  sum_.length += xs.back() - xs.front();
  sum_.width += bottom - top;
  sum_.compactness += away / count;
  sum_.defence_x += (xs[0] + xs[1] + xs[2]) / kDefenders;
  sum_.hull_area += hull_area(std::move(players));
}

TeamShape ShapeMeter::shape() const {
  TeamShape mean;
  if (count_ == 0) return mean;
  mean.length = sum_.length / count_;
  mean.width = sum_.width / count_;
  mean.compactness = sum_.compactness / count_;
  mean.defence_x = sum_.defence_x / count_;
  mean.hull_area = sum_.hull_area / count_;
  return mean;
}

void set_formation(std::vector<double> mean_x, TeamShape& shape) {
  if (mean_x.size() < 2 * kFewest) return;
  std::sort(mean_x.begin(), mean_x.end());
  std::vector<std::size_t> gaps(mean_x.size() - 1);
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = i;
  const auto width = [&](std::size_t i) { return mean_x[i + 1] - mean_x[i]; };
  std::sort(gaps.begin(), gaps.end(),
            [&](std::size_t a, std::size_t b) { return width(a) > width(b); });
  const bool four_lines = width(gaps[2]) >= kWideGap;
  gaps.resize(four_lines ? 3 : 2);
  std::sort(gaps.begin(), gaps.end());
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

}  // namespace cls::analysis
