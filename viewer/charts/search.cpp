// A search for the best parameters, over its generations.
#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;

constexpr double kScoreTop = 56.0;
constexpr double kScoreHeight = 150.0;
constexpr double kTraceHeight = 64.0;
constexpr double kTraceGap = 30.0;
constexpr double kGenerationsHeight = 34.0;

// Maps generations and values into a rectangle.
struct Panel {
  PlotPlace place;
  double low = 0.0;
  double high = 1.0;

  Vec2 at(double generation, double value) const {
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return {place.x(generation), place.bottom - (place.bottom - place.top) * share};
  }
};

void draw_frame(Drawing& drawing, const Panel& panel, const std::string& name,
                const std::array<std::string, 2>& ends) {
  drawing.text({panel.place.left, panel.place.top - 7}, name, "soft");
  for (std::size_t end = 0; end < 2; ++end) {
    const double y = end == 0 ? panel.place.bottom : panel.place.top;
    drawing.line({panel.place.left, y}, {panel.place.right, y}, {"axis"});
    drawing.text({panel.place.left - 8, y + 4}, ends[end], "soft", Anchor::kEnd);
  }
}

// Values that belong to generation `first`, `first` + 1, ...
void draw_series(Drawing& drawing, const Panel& panel, const std::vector<SearchData::Value>& series,
                 double first) {
  std::vector<Vec2> band;
  std::vector<Vec2> line;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double generation = first + static_cast<double>(i);
    line.push_back(panel.at(generation, series[i].center));
    band.push_back(panel.at(generation, series[i].high));
  }
  for (std::size_t i = series.size(); i > 0; --i) {
    band.push_back(panel.at(first + static_cast<double>(i - 1), series[i - 1].low));
  }

  drawing.polygon(band, {"left", 0.0, 0.2});
  drawing.polyline(line, {"left-line", 2.0});
}

std::vector<double> ends_of(const SearchData& data) {
  std::vector<double> ends = {data.even};
  for (const SearchData::Value& value : data.scores) {
    if (std::isfinite(value.low)) ends.push_back(value.low);
    if (std::isfinite(value.high)) ends.push_back(value.high);
  }
  return ends;
}

void draw_scores(Drawing& drawing, const SearchData& data, const PlotPlace& place) {
  const std::vector<double> ends = ends_of(data);
  const auto [low, high] = std::ranges::minmax(ends);
  Panel panel{place, low, high};
  if (!(panel.low < panel.high)) panel.high = panel.low + 1;

  draw_frame(drawing, panel, data.unit, {svg_number(panel.low), svg_number(panel.high)});
  drawing.line(panel.at(0, data.even), panel.at(place.frames, data.even), {"zero"});
  draw_series(drawing, panel, data.scores, 1.0);
}

void draw_generations(Drawing& drawing, const PlotPlace& place) {
  TimeAxis axis;
  axis.last = place.frames;
  const double step = std::max(1.0, std::ceil(place.frames / 10));
  for (double at = 0; at <= place.frames; at += step) axis.ticks.push_back({at, svg_number(at)});
  draw_time_axis(drawing, place, axis);
}

}  // namespace

std::string search_chart(const SearchData& data) {
  const auto traces = static_cast<double>(data.traces.size());
  const double height =
      kScoreTop + kScoreHeight + traces * (kTraceHeight + kTraceGap) + kGenerationsHeight;
  Drawing drawing = titled_drawing(data.title, height);

  PlotPlace place{76.0, kChartWidth - 20.0, kScoreTop, kScoreTop + kScoreHeight,
                  std::max<double>(1.0, static_cast<double>(data.scores.size()))};
  draw_scores(drawing, data, place);

  for (const SearchData::Trace& trace : data.traces) {
    place.top = place.bottom + kTraceGap;
    place.bottom = place.top + kTraceHeight;
    const Panel panel{place, 0.0, 1.0};
    draw_frame(drawing, panel, trace.name, trace.ends);
    if (!trace.values.empty()) {
      const double start = trace.values.front().center;
      drawing.line(panel.at(0, start), panel.at(place.frames, start), {"half"});
    }
    draw_series(drawing, panel, trace.values, 0.0);
  }

  draw_generations(drawing, place);
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
