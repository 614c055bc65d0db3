// The mean goal difference over the matches with its interval, and a histogram at its right.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/confidence.h"
#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;

constexpr double kHeight = 230.0;
constexpr double kTop = 56.0;
constexpr double kBottom = kHeight - 30.0;

struct Mean {
  double matches = 0.0;
  double mean = 0.0;
  double error = 0.0;  ///< half of the 95 % interval
};

// After each match, from the first one whose interval means something.
std::vector<Mean> means_of(const std::vector<int>& differences) {
  constexpr double kFirst = 5.0;

  std::vector<Mean> means;
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (const double difference : differences) {
    sum += difference;
    squares += difference * difference;
    ++count;
    if (count < kFirst) continue;

    const double mean = sum / count;
    const double variance = std::max(0.0, (squares - sum * mean) / (count - 1));
    means.push_back({count, mean, base::kNormal95 * std::sqrt(variance / count)});
  }
  return means;
}

// Maps means into the left half.
class MeansPlot {
 public:
  MeansPlot(const std::vector<Mean>& means, std::size_t matches) {
    place_.frames = std::max(1.0, static_cast<double>(matches));
    for (const Mean& one : means) {
      low_ = std::min(low_, one.mean - one.error);
      high_ = std::max(high_, one.mean + one.error);
    }
    high_ = std::max(high_, low_ + 1.0);
  }

  Vec2 at(double matches, double mean) const { return {place_.x(matches), y(mean)}; }

  void draw_axes(Drawing& drawing) const {
    drawing.text({place_.left, place_.top - 10}, "mean after each match, 95 % interval", "soft");

    const double step = tick_step(high_ - low_, 5.0, 0.1);
    const double last = std::floor(high_ / step);
    for (double tick = std::ceil(low_ / step); tick <= last; ++tick) {
      const double height = y(tick * step);
      drawing.line({place_.left, height}, {place_.right, height}, {tick == 0.0 ? "zero" : "axis"});
      drawing.text({place_.left - 8, height + 4}, svg_number(tick * step), "soft", Anchor::kEnd);
    }

    TimeAxis axis;
    const double matches = tick_step(place_.frames, 6.0, 1.0);
    for (double tick = matches; tick <= place_.frames; tick += matches) {
      axis.ticks.push_back({tick, svg_number(tick)});
    }
    draw_time_axis(drawing, place_, axis);
  }

 private:
  double y(double mean) const {
    return place_.bottom - (place_.bottom - place_.top) * (mean - low_) / (high_ - low_);
  }

  PlotPlace place_{44.0, 372.0, kTop, kBottom, 1.0};
  double low_ = 0.0;
  double high_ = 0.0;
};

void draw_means(Drawing& drawing, const DifferencesData& data) {
  const std::vector<Mean> means = means_of(data.differences);
  const MeansPlot plot(means, data.differences.size());
  plot.draw_axes(drawing);
  if (means.empty()) return;

  std::vector<Vec2> line;
  std::vector<Vec2> band;
  for (const Mean& one : means) {
    line.push_back(plot.at(one.matches, one.mean));
    band.push_back(plot.at(one.matches, one.mean + one.error));
  }
  for (auto one = means.rbegin(); one != means.rend(); ++one) {
    band.push_back(plot.at(one->matches, one->mean - one->error));
  }

  drawing.polygon(band, {"left", 0.0, 0.2});
  drawing.polyline(line, {"left-line", 2.0});
}

std::string_view fill_of_difference(double difference) {
  if (difference == 0.0) return fill_of(Tone::kBoth);
  return fill_of(difference > 0.0 ? Tone::kLeft : Tone::kRight);
}

void draw_histogram(Drawing& drawing, const DifferencesData& data) {
  constexpr double kLeft = 412.0;
  constexpr double kRight = kChartWidth - 16.0;
  constexpr double kCountHeight = 16.0;
  drawing.text({kLeft, kTop - 10}, "matches with each difference", "soft");
  drawing.line({kLeft, kBottom}, {kRight, kBottom}, {"zero"});

  std::map<double, double> counts;
  double most = 0.0;
  for (const int difference : data.differences) most = std::max(most, ++counts[difference]);
  if (counts.empty()) return;

  const double first = counts.begin()->first;
  const double columns = counts.rbegin()->first - first + 1;
  const double width = std::min(40.0, (kRight - kLeft) / columns);
  const double scale = (kBottom - kTop - kCountHeight) / most;
  const double labelled = tick_step(columns, 8.0, 1.0);

  for (const auto& [difference, count] : counts) {
    const double left = kLeft + (difference - first) * width;
    const double top = kBottom - count * scale;
    drawing.rect({left, top}, {std::max(1.0, width - 2), count * scale},
                 {fill_of_difference(difference)});
    if (std::fmod(difference, labelled) != 0.0) continue;
    const double middle = left + width / 2;
    drawing.text({middle, top - 5}, svg_number(count), "soft", Anchor::kMiddle);
    drawing.text({middle, kBottom + 17}, (difference > 0 ? "+" : "") + svg_number(difference),
                 "soft", Anchor::kMiddle);
  }
}

}  // namespace

std::string differences_chart(const DifferencesData& data) {
  Drawing drawing = titled_drawing(data.title, kHeight);
  draw_means(drawing, data);
  draw_histogram(drawing, data);
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
