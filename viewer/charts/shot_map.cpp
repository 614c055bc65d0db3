// Circles whose area is the goal probability; goals are filled.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using Shot = ShotMapData::Shot;

double radius_of(double expected) {
  constexpr double kCertainGoal = 20.0;
  constexpr double kMinRadius = 4.0;
  if (!std::isfinite(expected)) return kMinRadius;
  return std::max(kMinRadius, kCertainGoal * std::sqrt(std::clamp(expected, 0.0, 1.0)));
}

void draw_shot(Drawing& drawing, soccer::Vec2 center, const Shot& shot) {
  const double radius = radius_of(shot.expected);
  const Tone tone = tone_of(shot.team);
  drawing.circle(center, radius, {fill_of(tone), 0.0, shot.goal ? 1.0 : 0.18}, shot.tip);
  drawing.circle(center, radius, {shot.goal ? "ring" : line_of(tone), shot.goal ? 1.5 : 1.2});
}

void draw_key(Drawing& drawing, double y) {
  constexpr std::array<double, 3> kExamples = {0.05, 0.2, 0.5};
  double x = kChartMargin;
  for (const double expected : kExamples) {
    const double radius = radius_of(expected);
    drawing.circle({x + radius, y - 4}, radius, {"ball-line", 1.2});
    drawing.text({x + 2 * radius + 6, y}, svg_number(expected), "soft");
    x += 2 * radius + 44;
  }
  drawing.text({x, y}, "expected goals; filled: goal", "soft");
}

}  // namespace

std::string shot_map(const ShotMapData& data) {
  constexpr double kTeams = 46.0;
  constexpr double kTop = 58.0;
  constexpr double kBelow = 40.0;
  Drawing drawing = titled_drawing(data.title, height_with_pitch(kTop, kBelow));
  draw_teams(drawing, kTeams, data.teams);
  const PitchPlace place = draw_pitch(drawing, kTop);

  // Small circles and goals last: nothing hides them.
  std::vector<const Shot*> shots;
  for (const Shot& shot : data.shots) shots.push_back(&shot);
  std::ranges::stable_sort(shots, {}, [](const Shot* shot) {
    return std::pair(shot->goal, -radius_of(shot->expected));
  });

  for (const Shot* shot : shots) draw_shot(drawing, place.at(shot->position), *shot);
  draw_key(drawing, place.bottom() + 25);
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
