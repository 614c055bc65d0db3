// Elements with presentation attributes and classes only: a Content-Security-Policy blocks inline
// styles.
#include "viewer/charts/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/decimal_text.h"
#include "base/text/enum_names.h"
#include "base/text/utf8.h"
#include "base/text/xml.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;

// Text has a contrast of at least 4.5:1, marks of at least 3:1.
constexpr std::string_view kChartStyle =
    ".chart{font:13px system-ui,\"Segoe UI\",Roboto,\"DejaVu Sans\",sans-serif}"
    ".chart text{fill:#1b1b1b}.chart .title{font-size:15px;font-weight:600}"
    ".chart .soft{fill:#595f5b;font-size:12px}.chart .unum{font-size:12px;font-weight:600}"
    ".chart .ground{fill:#fff}.chart .pitch{fill:#eef3ee}"
    ".chart .lines{fill:none;stroke:#9caaa0;stroke-width:1.2}.chart .spot{fill:#9caaa0}"
    ".chart .axis{stroke:#dfe3e0}.chart .zero{stroke:#868e89}"
    ".chart .half{stroke:#868e89;stroke-dasharray:3 3}"
    ".chart .left{fill:#0b5fa5}.chart .right{fill:#a84300}.chart .ball-heat{fill:#4d4d4d}"
    ".chart .left-line{fill:none;stroke:#0b5fa5}"
    ".chart .right-line{fill:none;stroke:#a84300}"
    ".chart .ball-line{fill:none;stroke:#1b1b1b}"
    ".chart .ring{fill:none;stroke:#fff}"
    ".chart .ball{fill:#fff;stroke:#1b1b1b;stroke-width:1.5}.chart .on{fill:#fff}"
    "@media screen and (prefers-color-scheme:dark){"
    ".chart text{fill:#e8ecea}.chart .soft{fill:#a9b3ad}"
    ".chart .ground{fill:#161616}.chart .pitch{fill:#1c2420}"
    ".chart .lines{stroke:#5d6b63}.chart .spot{fill:#5d6b63}"
    ".chart .axis{stroke:#2c3430}.chart .zero,.chart .half{stroke:#7c8781}"
    ".chart .left{fill:#5ab8f2}.chart .right{fill:#f2a73b}.chart .ball-heat{fill:#c9d1cc}"
    ".chart .left-line{stroke:#5ab8f2}.chart .right-line{stroke:#f2a73b}"
    ".chart .ball-line{stroke:#e8ecea}.chart .ring{stroke:#161616}"
    ".chart .ball{fill:#e8ecea;stroke:#161616}.chart .on{fill:#10161d}}";

constexpr auto kAnchors =
    base::enum_names<Anchor>("", " text-anchor=\"middle\"", " text-anchor=\"end\"");

bool finite(Vec2 point) { return std::isfinite(point.x) && std::isfinite(point.y); }

std::string attributes(Look look) {
  std::string text = fmt::format(" class=\"{}\"", look.kind);
  // A style sheet would override the attribute: classes of lines have no width.
  if (look.width > 0.0) text += fmt::format(" stroke-width=\"{}\"", svg_number(look.width));
  if (look.opacity < 1.0) text += fmt::format(" opacity=\"{}\"", svg_number(look.opacity));
  return text;
}

}  // namespace

std::string svg_number(double value) {
  return std::isfinite(value) ? base::decimal_text(value, 2) : "0";
}

std::string shortened_name(std::string_view name, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < count && end < name.size(); ++i) {
    end += std::max<std::size_t>(1, base::utf8_sequence_length(name.substr(end)));
  }
  std::string text(name.substr(0, end));
  return end < name.size() ? text + "..." : text;
}

Drawing::Drawing(double width, double height, std::string_view label) : width_(width) {
  text_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">\n",
      svg_number(width), svg_number(height), base::escape_xml(label));
  rect({}, {width, height}, {"ground"});
}

void Drawing::line(Vec2 from, Vec2 to, Look look) {
  if (!finite(from) || !finite(to)) return;
  text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", svg_number(from.x),
                       svg_number(from.y), svg_number(to.x), svg_number(to.y), attributes(look));
}

void Drawing::rect(Vec2 corner, Vec2 size, Look look) {
  if (!finite(corner) || !finite(size)) return;
  text_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", svg_number(corner.x),
                  svg_number(corner.y), svg_number(size.x), svg_number(size.y), attributes(look));
}

void Drawing::circle(Vec2 center, double radius, Look look, std::string_view tip) {
  if (!finite(center) || !std::isfinite(radius)) return;
  text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}", svg_number(center.x),
                       svg_number(center.y), svg_number(radius), attributes(look));
  text_ +=
      tip.empty() ? "/>\n" : fmt::format("><title>{}</title></circle>\n", base::escape_xml(tip));
}

void Drawing::points(std::string_view element, const std::vector<Vec2>& all, Look look) {
  text_ += fmt::format("<{} points=\"", element);
  const char* separator = "";
  for (const Vec2 point : all) {
    if (!finite(point)) continue;
    text_ += fmt::format("{}{},{}", separator, svg_number(point.x), svg_number(point.y));
    separator = " ";
  }
  text_ += fmt::format("\"{}/>\n", attributes(look));
}

void Drawing::polyline(const std::vector<Vec2>& all, Look look) { points("polyline", all, look); }

void Drawing::polygon(const std::vector<Vec2>& all, Look look) { points("polygon", all, look); }

void Drawing::path(std::string_view data, Look look) {
  text_ += fmt::format("<path d=\"{}\"{}/>\n", data, attributes(look));
}

void Drawing::text(Vec2 at, std::string_view text, std::string_view kind, Anchor anchor) {
  if (!finite(at) || text.empty()) return;
  const std::string_view where = kAnchors.name(anchor);
  const std::string look = kind.empty() ? "" : fmt::format(" class=\"{}\"", kind);
  text_ += fmt::format("<text x=\"{}\" y=\"{}\"{}{}>{}</text>\n", svg_number(at.x),
                       svg_number(at.y), look, where, base::escape_xml(text));
}

std::string Drawing::finish() && { return std::move(text_) + "</svg>\n"; }

std::string_view chart_style() { return kChartStyle; }

std::string standalone_svg(std::string_view chart) {
  const std::size_t end = chart.find(">\n") + 2;
  return fmt::format("{}<style>{}</style>\n{}", chart.substr(0, end), kChartStyle,
                     chart.substr(end));
}

}  // namespace cls::viewer
