// A dot with its interval for each team.
#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

constexpr double kNames = 160.0;
constexpr double kRatingsTop = 36.0;
constexpr double kRow = 24.0;
constexpr double kAxisHeight = 28.0;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

// Zero is inside.
Range range_of(const RatingsData& data) {
  Range range;
  for (const RatingsData::Team& team : data.teams) {
    if (!std::isfinite(team.elo) || !std::isfinite(team.error)) continue;
    range.low = std::min(range.low, team.elo - team.error);
    range.high = std::max(range.high, team.elo + team.error);
  }
  range.high = std::max(range.high, range.low + 1.0);
  return range;
}

}  // namespace

std::string ratings_chart(const RatingsData& data) {
  const double bottom = kRatingsTop + kRow * static_cast<double>(data.teams.size());
  Drawing drawing = titled_drawing(data.title, bottom + kAxisHeight);

  const Range range = range_of(data);
  const double pixels = (kChartWidth - kNames - 24.0) / (range.high - range.low);
  const auto x = [&](double elo) { return kNames + (elo - range.low) * pixels; };

  const double step = tick_step(range.high - range.low, 8.0, 1.0);
  const double last = std::floor(range.high / step);
  for (double tick = std::ceil(range.low / step); tick <= last; ++tick) {
    const double at = x(tick * step);
    drawing.line({at, kRatingsTop}, {at, bottom}, {tick == 0.0 ? "zero" : "axis"});
    drawing.text({at, bottom + 17}, (tick > 0 ? "+" : "") + svg_number(tick * step), "soft",
                 Anchor::kMiddle);
  }

  double y = kRatingsTop + kRow / 2;
  for (const RatingsData::Team& team : data.teams) {
    drawing.text({kNames - 12, y + 4.5}, shortened_name(team.name), "", Anchor::kEnd);
    drawing.line({x(team.elo - team.error), y}, {x(team.elo + team.error), y}, {"left-line", 2.0});
    drawing.circle({x(team.elo), y}, 5.0, {"left"});
    y += kRow;
  }
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
