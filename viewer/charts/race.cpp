// Steps over time: the sum of each team.
#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;
using Step = RaceData::Step;

constexpr double kRaceHeight = 336.0;

double gain_of(const Step& step) {
  return std::isfinite(step.gain) ? std::max(0.0, step.gain) : 0.0;
}

double highest_sum(const RaceData& data) {
  double most = 0.0;
  for (const std::vector<Step>& steps : data.steps) {
    double sum = 0.0;
    for (const Step& step : steps) sum += gain_of(step);
    most = std::max(most, sum);
  }
  return most;
}

class Race {
 public:
  Race(Drawing& drawing, const RaceData& data)
      : drawing_(drawing), data_(data), range_(std::max(0.2, highest_sum(data) * 1.08)) {
    place_ = {44.0, kChartWidth - 52.0, 62.0, kRaceHeight - 30.0, std::max(1.0, data.axis.last)};
  }

  void draw() {
    draw_time_axis(drawing_, place_, data_.axis);

    constexpr double kParts = 5.0;
    const double step = tick_step(range_, kParts, 0.05);
    for (int i = 0; i * step <= range_; ++i) {
      const double at = y(i * step);
      drawing_.line({place_.left, at}, {place_.right, at}, {i == 0 ? "zero" : "axis"});
      drawing_.text({place_.left - 8, at + 4}, svg_number(i * step), "soft", Anchor::kEnd);
    }

    const std::array<Vec2, 2> ends = {draw_line(0), draw_line(1)};
    draw_ends(ends);
  }

 private:
  double y(double sum) const { return place_.bottom - (place_.bottom - place_.top) * sum / range_; }

  // Returns the end of the line.
  Vec2 draw_line(std::size_t team) {
    double sum = 0.0;
    std::vector<Vec2> points = {{place_.left, y(0.0)}};
    std::vector<std::pair<Vec2, const Step*>> goals;
    for (const Step& step : data_.steps[team]) {
      const double x = place_.x(step.at);
      points.push_back({x, y(sum)});
      sum += gain_of(step);
      points.push_back({x, y(sum)});
      if (step.goal) goals.emplace_back(points.back(), &step);
    }

    points.push_back({place_.right, y(sum)});
    drawing_.polyline(points, {line_of(tone_of(team)), 2.0});
    for (const auto& [at, step] : goals) {
      drawing_.circle(at, 5.5, {fill_of(tone_of(team))}, step->tip);
      drawing_.circle(at, 5.5, {"ring", 1.5});
    }

    sums_[team] = sum;
    return points.back();
  }

  // The final sums, moved apart where they would overlap.
  void draw_ends(std::array<Vec2, 2> ends) {
    constexpr double kLine = 15.0;
    const std::size_t upper = ends[0].y <= ends[1].y ? 0 : 1;
    Vec2& high = ends[upper];
    Vec2& low = ends[1 - upper];
    if (low.y - high.y < kLine) {
      high.y = std::min(high.y, place_.bottom - kLine);
      low.y = high.y + kLine;
    }

    for (std::size_t team = 0; team < 2; ++team) {
      drawing_.text(ends[team] + Vec2{8.0, 4.0}, svg_number(sums_[team]), fill_of(tone_of(team)));
    }
  }

  Drawing& drawing_;
  const RaceData& data_;
  double range_;
  PlotPlace place_;
  std::array<double, 2> sums_ = {};
};

}  // namespace

std::string race_chart(const RaceData& data) {
  Drawing drawing = titled_drawing(data.title, kRaceHeight);
  draw_teams(drawing, 46.0, data.teams);
  Race(drawing, data).draw();
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
