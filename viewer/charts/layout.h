// Common parts of charts: sizes, title, legend, pitch, time axis.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "viewer/charts/charts.h"
#include "viewer/charts/drawing.h"

namespace cls::viewer {

constexpr double kChartWidth = 640.0;
constexpr double kChartMargin = 12.0;

/// "left", "right" or "ball-heat": the class that fills a shape; "left-line" or "right-line".
std::string_view fill_of(Tone tone);
std::string_view line_of(Tone tone);

/// A drawing of kChartWidth with the title, and its note at the right. Both are shortened to fit.
Drawing titled_drawing(const ChartTitle& title, double height);

/// One line with a mark and a text for each team.
void draw_teams(Drawing& drawing, double y, const std::array<std::string, 2>& teams);

/// Maps the pitch into a drawing.
struct PitchPlace {
  soccer::Vec2 center;  ///< pixels
  double scale = 1.0;   ///< pixels per meter

  soccer::Vec2 at(soccer::Vec2 meters) const { return center + meters * scale; }
  double bottom() const;
};

/// Draws a pitch over the whole width, below `top`. Pixels.
PitchPlace draw_pitch(Drawing& drawing, double top);

/// Height of a chart with a pitch below `top` and `below` pixels under it.
double height_with_pitch(double top, double below);

/// The area of a chart over time.
struct PlotPlace {
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
  double frames = 1.0;

  double x(double frame) const { return left + (right - left) * frame / frames; }
};

/// Draws ticks and half times.
void draw_time_axis(Drawing& drawing, const PlotPlace& place, const TimeAxis& axis);

/// The distance of ticks: 1, 2 or 5 times a power of ten, at least `finest` (0.01 or more), that
/// divides `range` into at most `parts`.
double tick_step(double range, double parts, double finest);

}  // namespace cls::viewer
