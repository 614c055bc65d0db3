// Discs with numbers, as the replay page draws them.
#include <fmt/format.h>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;
using Player = SceneData::Player;

void draw_player(Drawing& drawing, const PitchPlace& place, const Player& player) {
  constexpr double kRadius = 8.5;
  const Vec2 center = place.at(player.position);
  const Tone tone = tone_of(player.team);

  if (player.marked) drawing.circle(center, kRadius + 5.5, {line_of(tone), 2.5});
  drawing.line(center, center + soccer::polar_degrees(kRadius + 5, player.body),
               {line_of(tone), 3});
  drawing.circle(center, kRadius, {fill_of(tone)});
  // Color is never the only difference.
  if (player.team == 1) drawing.circle(center, kRadius + 2.2, {line_of(tone), 1.2});
  drawing.text(center + Vec2{0.0, 4.0}, fmt::to_string(player.unum), "unum on", Anchor::kMiddle);
}

}  // namespace

std::string scene_chart(const SceneData& data) {
  constexpr double kTeams = 46.0;
  constexpr double kTop = 58.0;
  Drawing drawing = titled_drawing(data.title, height_with_pitch(kTop, kChartMargin));
  const bool named = !data.teams[0].empty() || !data.teams[1].empty();
  if (named) draw_teams(drawing, kTeams, data.teams);
  const PitchPlace place = draw_pitch(drawing, kTop);

  std::vector<Vec2> path;
  for (const Vec2 point : data.ball_path) path.push_back(place.at(point));
  if (path.size() > 1) drawing.polyline(path, {"ball-line", 1.5});

  for (const Player& player : data.players) draw_player(drawing, place, player);
  drawing.circle(place.at(data.ball), 4.0, {"ball"});
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
