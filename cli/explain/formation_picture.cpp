// Draws home positions with the field of `cls watch --view terminal` and the scenes of reports.
#include "cli/explain/formation_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/io/whole_file.h"
#include "base/text/table.h"
#include "gamelog/record/frame.h"
#include "player/formation/formation_file.h"
#include "player/formation/formation_set.h"
#include "viewer/charts/charts.h"
#include "viewer/charts/drawing.h"
#include "viewer/terminal/field_picture.h"
#include "viewer/terminal/screen.h"

namespace cls::cli {
namespace {

std::string title_of(const FormationPicture& picture) {
  return fmt::format("{}, ball at {:g}, {:g}", picture.name, picture.ball.x, picture.ball.y);
}

}  // namespace

std::vector<std::string> formation_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < player::kFormationKindCount; ++i) {
    names.emplace_back(file_name(static_cast<player::FormationKind>(i)));
  }
  return names;
}

base::Result<FormationPicture> find_formation(const std::string& name, soccer::Vec2 ball) {
  const std::vector<std::string> names = formation_names();
  const auto built_in = std::ranges::find_if(
      names, [&name](const std::string& one) { return std::string_view(one).starts_with(name); });

  std::string text;
  std::string label = name;
  if (built_in != names.end()) {
    label = *built_in;
    text = player::built_in_formation(label);
  } else {
    const auto read = base::read_text(name);
    if (!read) {
      return base::Error{
          fmt::format("no formation '{}': a file, or one of {}", name, fmt::join(names, ", "))};
    }
    text = *read;
  }

  TRY_INIT(const auto formation, player::parse_formation(text, label));
  return FormationPicture{label, ball, formation.positions(ball)};
}

std::string formation_text(const FormationPicture& picture, std::size_t width) {
  constexpr std::size_t kMaxWidth = 100;
  // A character has two dots across and four down; the pitch is 110 by 70 meters with its goals.
  constexpr double kRowsPerColumn = 0.5 * 70.0 / 110.0;
  const int columns = static_cast<int>(std::min(width, kMaxWidth));
  const int rows = static_cast<int>(columns * kRowsPerColumn) + 1;

  gamelog::Frame frame;
  frame.ball_position = picture.ball;
  for (std::size_t i = 0; i < picture.players.size(); ++i) {
    frame.players[i].state = gamelog::kStateEnabled;
    frame.players[i].position = picture.players[i];
  }
  viewer::Screen screen(columns, rows);
  viewer::draw_field(frame, {0, rows, false}, screen);

  base::Table table;
  table.add_column("player", base::Table::Align::kRight);
  table.add_column("x", base::Table::Align::kRight);
  table.add_column("y", base::Table::Align::kRight);
  for (std::size_t i = 0; i < picture.players.size(); ++i) {
    const soccer::Vec2 at = picture.players[i];
    table.add_row(
        {fmt::to_string(i + 1), fmt::format("{:.1f}", at.x), fmt::format("{:.1f}", at.y)});
  }
  return fmt::format("{} (A and B are 10 and 11; the team attacks to the right)\n{}\n{}",
                     title_of(picture), screen.text(), table.format_text({0, width, 1}));
}

std::string formation_svg(const FormationPicture& picture) {
  viewer::SceneData scene;
  scene.title = {title_of(picture), "attacks to the right"};
  scene.ball = picture.ball;
  for (std::size_t i = 0; i < picture.players.size(); ++i) {
    viewer::SceneData::Player player;
    player.unum = static_cast<int>(i) + 1;
    player.position = picture.players[i];
    scene.players.push_back(player);
  }
  return viewer::standalone_svg(viewer::scene_chart(scene));
}

}  // namespace cls::cli
