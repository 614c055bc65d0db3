// Builds the text of an SVG image.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.h"

namespace cls::viewer {

/// A number in an attribute: at most two decimals, "0" for negative zero and for values that are
/// not finite.
std::string svg_number(double value);

/// The first `count` characters of a name, with an ellipsis if there are more. Invalid UTF-8 counts
/// bytes.
std::string shortened_name(std::string_view name, std::size_t count = 20);

/// How a shape looks.
struct Look {
  std::string_view kind;  ///< class of chart_style()
  double width = 0.0;     ///< of a line in pixels; 0: one pixel, or that of the class
  double opacity = 1.0;
};

enum class Anchor : unsigned char { kStart, kMiddle, kEnd };

/// A chart under construction. Coordinates are pixels; y points down. Texts are escaped. Shapes
/// with a coordinate that is not finite are left out.
class Drawing {
 public:
  /// `label` describes the image to readers who do not see it.
  Drawing(double width, double height, std::string_view label);

  void line(soccer::Vec2 from, soccer::Vec2 to, Look look);
  void rect(soccer::Vec2 corner, soccer::Vec2 size, Look look);
  /// `tip` is shown on hover.
  void circle(soccer::Vec2 center, double radius, Look look, std::string_view tip = {});
  void polyline(const std::vector<soccer::Vec2>& points, Look look);
  void polygon(const std::vector<soccer::Vec2>& points, Look look);
  /// `data` as the attribute d of a path.
  void path(std::string_view data, Look look);
  void text(soccer::Vec2 at, std::string_view text, std::string_view kind,
            Anchor anchor = Anchor::kStart);

  double width() const { return width_; }
  std::string finish() &&;

 private:
  void points(std::string_view element, const std::vector<soccer::Vec2>& all, Look look);

  double width_;
  std::string text_;
};

/// The style sheet of all charts. Light, or dark where the reader's browser prefers it.
std::string_view chart_style();

/// A chart as a file of its own: with the style sheet.
std::string standalone_svg(std::string_view chart);

}  // namespace cls::viewer
