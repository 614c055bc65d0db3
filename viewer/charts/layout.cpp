// Draws the common parts of charts.
#include "viewer/charts/layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/enum_names.h"
#include "soccer/pitch.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;

constexpr auto kFills = base::enum_names<Tone>("left", "right", "ball-heat");
constexpr auto kLines = base::enum_names<Tone>("left-line", "right-line", "ball-line");

// Goals stand outside of the lines, and marks on the lines need room.
constexpr double kPitchFrame = 3.0;

double pitch_scale() {
  return (kChartWidth - 2 * kChartMargin) / (soccer::kPitchLength + 2 * kPitchFrame);
}

std::string rect_path(const PitchPlace& place, const soccer::Rect& rect) {
  const Vec2 a = place.at({rect.left, rect.top});
  const Vec2 b = place.at({rect.right, rect.bottom});
  return fmt::format("M{} {}H{}V{}H{}Z", svg_number(a.x), svg_number(a.y), svg_number(b.x),
                     svg_number(b.y), svg_number(a.x));
}

// Lines of the half that `sign` names.
std::string half_path(const PitchPlace& place, double sign) {
  const auto box = [&](double from, double to, double width) {
    const double a = sign * (soccer::kHalfLength - from);
    const double b = sign * (soccer::kHalfLength - to);
    return rect_path(place, {std::min(a, b), std::max(a, b), -width / 2, width / 2});
  };

  constexpr double kGoalWidth = 14.02;  // of rcssserver, wider than the rules of soccer say
  return box(0.0, soccer::kPenaltyAreaLength, soccer::kPenaltyAreaWidth) +
         box(0.0, soccer::kGoalAreaLength, soccer::kGoalAreaWidth) +
         box(-soccer::kGoalDepth, 0.0, kGoalWidth);
}

}  // namespace

std::string_view fill_of(Tone tone) { return kFills.name(tone); }
std::string_view line_of(Tone tone) { return kLines.name(tone); }

Drawing titled_drawing(const ChartTitle& title, double height) {
  constexpr double kBaseline = 22.0;
  constexpr std::size_t kCharacters = 52;
  Drawing drawing(kChartWidth, height, title.text);
  drawing.text({kChartMargin, kBaseline}, shortened_name(title.text, kCharacters), "title");
  drawing.text({kChartWidth - kChartMargin, kBaseline}, title.note, "soft", Anchor::kEnd);
  return drawing;
}

void draw_teams(Drawing& drawing, double y, const std::array<std::string, 2>& teams) {
  constexpr double kMark = 5.0;
  for (std::size_t team = 0; team < 2; ++team) {
    const double x = kChartMargin + static_cast<double>(team) * drawing.width() / 2;
    drawing.circle({x + kMark, y - kMark + 0.5}, kMark, {fill_of(tone_of(team))});
    drawing.text({x + 3 * kMark, y}, teams[team], "");
  }
}

double PitchPlace::bottom() const { return center.y + (soccer::kHalfWidth + kPitchFrame) * scale; }

PitchPlace draw_pitch(Drawing& drawing, double top) {
  const double scale = pitch_scale();
  const PitchPlace place{{drawing.width() / 2, top + (soccer::kHalfWidth + kPitchFrame) * scale},
                         scale};
  const Vec2 size = Vec2{soccer::kHalfLength + kPitchFrame, soccer::kHalfWidth + kPitchFrame};
  drawing.rect(place.at(-size), 2 * scale * size, {"pitch"});

  const Vec2 upper = place.at({0.0, -soccer::kHalfWidth});
  const std::string lines = rect_path(place, {-soccer::kHalfLength, soccer::kHalfLength,
                                              -soccer::kHalfWidth, soccer::kHalfWidth}) +
                            fmt::format("M{} {}v{}", svg_number(upper.x), svg_number(upper.y),
                                        svg_number(soccer::kPitchWidth * scale)) +
                            half_path(place, -1.0) + half_path(place, 1.0);
  drawing.path(lines, {"lines"});
  drawing.circle(place.center, soccer::kCenterCircleRadius * scale, {"lines"});

  constexpr double kSpotRadius = 2.0;
  const double spot = soccer::kHalfLength - soccer::kPenaltySpotDistance;
  for (const double x : {-spot, 0.0, spot}) {
    drawing.circle(place.at({x, 0.0}), kSpotRadius, {"spot"});
  }
  return place;
}

double height_with_pitch(double top, double below) {
  return top + 2 * (soccer::kHalfWidth + kPitchFrame) * pitch_scale() + below;
}

void draw_time_axis(Drawing& drawing, const PlotPlace& place, const TimeAxis& axis) {
  constexpr double kMinDistance = 44.0;  // of the middles of two texts
  constexpr double kHalfText = 16.0;     // of four digits
  double last = -kMinDistance;
  for (const TimeAxis::Tick& tick : axis.ticks) {
    const double x = place.x(tick.at);
    if (x - last < kMinDistance || x > place.right + 1) continue;
    last = x;
    drawing.line({x, place.top}, {x, place.bottom}, {"axis"});
    const bool at_edge = x + kHalfText > drawing.width() - kChartMargin;
    drawing.text({x, place.bottom + 17}, tick.text, "soft",
                 at_edge ? Anchor::kEnd : Anchor::kMiddle);
  }

  for (const double half : axis.halves) {
    drawing.line({place.x(half), place.top}, {place.x(half), place.bottom}, {"half"});
  }
}

double tick_step(double range, double parts, double finest) {
  constexpr double kMaxUnit = 1e15;
  for (double unit = 0.01; unit < kMaxUnit; unit *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * unit;
      if (step >= finest && range / step <= parts) return step;
    }
  }
  return kMaxUnit;
}

}  // namespace cls::viewer
