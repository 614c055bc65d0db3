// Cells of equal size, in levels of opacity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kLevels = 9;  // 0: nothing to draw

// Half square root, half linear: rare places are visible, too.
std::size_t level_of(double value, double most) {
  if (!(value > 0.0) || !(most > 0.0)) return 0;
  const double linear = std::min(1.0, value / most);
  const double share = (std::sqrt(linear) + linear) / 2;
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(share * (kLevels - 1))), 1,
                                 kLevels - 1);
}

double largest(const std::vector<double>& cells) {
  double most = 0.0;
  for (const double cell : cells) {
    if (std::isfinite(cell)) most = std::max(most, cell);
  }
  return most;
}

}  // namespace

std::string heat_map(const HeatMapData& data) {
  constexpr double kTop = 34.0;
  Drawing drawing = titled_drawing(data.title, height_with_pitch(kTop, kChartMargin));

  const bool complete = data.cells.size() == data.columns * data.rows && !data.cells.empty();
  const PitchPlace place = draw_pitch(drawing, kTop);
  if (!complete) return std::move(drawing).finish();

  const double size = data.cell_size;
  const double left = -size * static_cast<double>(data.columns) / 2;
  const double top = -size * static_cast<double>(data.rows) / 2;
  const std::string side = svg_number(size * place.scale);
  const double most = largest(data.cells);

  for (std::size_t level = 1; level < kLevels; ++level) {
    std::string cells;
    for (std::size_t i = 0; i < data.cells.size(); ++i) {
      if (!std::isfinite(data.cells[i]) || level_of(data.cells[i], most) != level) continue;
      const auto column = static_cast<double>(i % data.columns);
      const auto row = static_cast<double>(i / data.columns);
      const soccer::Vec2 corner = place.at({left + column * size, top + row * size});
      cells += fmt::format("M{} {}h{}v{}h-{}z", svg_number(corner.x), svg_number(corner.y), side,
                           side, side);
    }
    const double opacity = 0.9 * static_cast<double>(level) / (kLevels - 1);
    if (!cells.empty()) drawing.path(cells, {fill_of(data.tone), 0.0, opacity});
  }
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
