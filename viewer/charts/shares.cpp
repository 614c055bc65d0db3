// Strips over time: above the middle the left team has more, below it the right team.
#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;
using Strip = SharesData::Strip;

constexpr double kTop = 62.0;
constexpr double kStripHeight = 92.0;
constexpr double kStripGap = 30.0;
constexpr double kAxisHeight = 30.0;

// A run of known shares as points (frame, share), with a point wherever it crosses the middle.
using Run = std::vector<Vec2>;

std::vector<Run> runs_of(const Strip& strip, double last) {
  std::vector<Run> runs;
  bool open = false;
  const auto count = static_cast<double>(std::max<std::size_t>(2, strip.shares.size()) - 1);
  for (std::size_t i = 0; i < strip.shares.size(); ++i) {
    if (!std::isfinite(strip.shares[i])) {
      open = false;
      continue;
    }

    const Vec2 point = {last * static_cast<double>(i) / count,
                        std::clamp(strip.shares[i], 0.0, 1.0)};

    if (!open) runs.emplace_back();
    open = true;
    Run& run = runs.back();
    if (!run.empty() && (run.back().y - 0.5) * (point.y - 0.5) < 0.0) {
      const double part = (0.5 - run.back().y) / (point.y - run.back().y);
      run.push_back({run.back().x + part * (point.x - run.back().x), 0.5});
    }
    run.push_back(point);
  }
  return runs;
}

// Between the middle and the shares of one team's half.
std::vector<Vec2> area_of(const Run& run, const PlotPlace& place, std::size_t team) {
  const auto at = [&](double frame, double share) {
    return Vec2{place.x(frame), place.bottom - (place.bottom - place.top) * share};
  };

  std::vector<Vec2> points = {at(run.front().x, 0.5)};
  for (const Vec2 point : run) {
    points.push_back(at(point.x, team == 0 ? std::max(0.5, point.y) : std::min(0.5, point.y)));
  }
  points.push_back(at(run.back().x, 0.5));
  return points;
}

void draw_strip(Drawing& drawing, const PlotPlace& place, const Strip& strip) {
  drawing.text({place.left, place.top - 7}, strip.name, "soft");
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = place.bottom - (place.bottom - place.top) * share;
    drawing.line({place.left, y}, {place.right, y}, {share == 0.5 ? "zero" : "axis"});
    drawing.text({place.left - 8, y + 4}, svg_number(100 * share), "soft", Anchor::kEnd);
  }

  for (const Run& run : runs_of(strip, place.frames)) {
    for (std::size_t team = 0; team < 2; ++team) {
      drawing.polygon(area_of(run, place, team), {fill_of(tone_of(team)), 0.0, 0.85});
    }
  }
}

}  // namespace

std::string shares_chart(const SharesData& data) {
  const auto strips = static_cast<double>(data.strips.size());
  const double height = kTop + strips * (kStripHeight + kStripGap) + kAxisHeight;
  Drawing drawing = titled_drawing(data.title, height);
  draw_teams(drawing, 46.0, data.teams);

  PlotPlace place{44.0, kChartWidth - 20.0, kTop + kStripGap - kChartMargin, 0.0,
                  std::max(1.0, data.axis.last)};
  PlotPlace all = place;
  all.bottom = place.top + strips * (kStripHeight + kStripGap) - kStripGap;
  draw_time_axis(drawing, all, data.axis);

  for (const Strip& strip : data.strips) {
    place.bottom = place.top + kStripHeight;
    draw_strip(drawing, place, strip);
    place.top = place.bottom + kStripGap;
  }
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
