// The page, its style and its chart.
#include "orchestration/tournament/report/report_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/system/version.h"
#include "base/text/xml.h"
#include "orchestration/tournament/report/report_bracket.h"
#include "orchestration/tournament/report/report_tables.h"
#include "viewer/report/report_page.h"

namespace cls::orchestration::tournament {
namespace {

using viewer::text_element;

std::string table_html(const ReportTable& table, std::string_view kind = "scroll") {
  return viewer::table_section(table.title, table.table, table.note, kind);
}

// A step of 1, 2 or 5 times a power of ten that divides `range` into at most eight parts.
double tick_step(double range) {
  double step = 1.0;
  for (const double factors[] = {2.0, 2.5, 2.0}; range / step > 8;) {
    for (const double factor : factors) {
      if (range / step > 8) step *= factor;
    }
  }
  return step;
}

// A dot with its 95 % interval for each rated team, best first.
std::string ratings_chart(const Report& report) {
  constexpr double kNames = 150;
  constexpr double kWidth = 560;
  constexpr double kRow = 24;
  const std::vector<std::size_t> teams = rated_teams(report);
  const Ratings& ratings = report.ratings;
  double low = 0.0;
  double high = 0.0;
  for (const std::size_t team : teams) {
    low = std::min(low, ratings.elo[team] - ratings.error[team]);
    high = std::max(high, ratings.elo[team] + ratings.error[team]);
  }
  const double range = std::max(1.0, high - low);
  const auto x = [&](double elo) { return kNames + (elo - low) / range * kWidth; };
  const double bottom = kRow * static_cast<double>(teams.size()) + 4;
  std::string text = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" role=\"img\" "
      "aria-label=\"Ratings in Elo with their 95 % intervals, as in the table\">\n",
      kNames + kWidth + 20, bottom + 22, kNames + kWidth + 20);
  auto out = std::back_inserter(text);
  const double step = tick_step(range);
  for (double tick = std::ceil(low / step) * step; tick <= high; tick += step) {
    const bool zero = std::abs(tick) < step / 2;
    fmt::format_to(
        out,
        "<line class=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"0\" y2=\"{:.0f}\"/>"
        "<text class=\"tick\" x=\"{:.1f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>\n",
        zero ? "zero" : "axis", x(tick), x(tick), bottom, x(tick), bottom + 16,
        zero ? "0" : difference_text(tick));
  }
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const std::size_t team = teams[i];
    const double y = kRow * (static_cast<double>(i) + 0.5) + 2;
    const double elo = ratings.elo[team];
    fmt::format_to(
        out,
        "<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>"
        "<line class=\"bar\" stroke-width=\"2\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>"
        "<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{}\" r=\"5\"/>\n",
        kNames - 12, y + 4.5, base::escape_xml(report.team(static_cast<int>(team))),
        x(elo - ratings.error[team]), x(elo + ratings.error[team]), y, y, x(elo), y);
  }
  return text + "</svg>\n";
}

std::string ratings_html(const Report& report) {
  const ReportTable table = ratings_table(report);
  if (table.empty()) return {};
  return text_element("h2", table.title) + ratings_chart(report) +
         viewer::table_box(table.title, table.table) + text_element("p", table.note, "note");
}

std::string warnings_html(const Report& report) {
  const std::vector<std::string> lines = warning_lines(report);
  if (lines.empty()) return {};
  std::string text = fmt::format("<h2>{} warnings</h2>\n<ul>\n", lines.size());
  for (const std::string& line : lines) text += text_element("li", line);
  return text + "</ul>\n";
}

std::string head_html(const Report& report) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}{2}</style>\n</head>\n<body>\n<main>\n"
      "<header class=\"head\">\n<h1>{0}</h1>\n",
      base::escape_xml(report.name), viewer::report_style(), kBracketStyle);
  text += text_element("p", headline(report), "state");
  for (const std::string& line : head_lines(report)) text += text_element("p", line);
  return text + "</header>\n";
}

}  // namespace

std::string report_html(const Report& report) {
  constexpr std::size_t kMaxNamedColumns = 8;
  std::string text = head_html(report);
  for (const RankedTable& ranked : report.tables) {
    text += table_html(standings_table(report, ranked, Headings::kLong));
  }
  if (!report.bracket.empty()) text += "<h2>bracket</h2>\n" + bracket_html(report);
  const bool numbered = report.config->teams.size() > kMaxNamedColumns;
  text += table_html(crosstable(report, numbered), numbered ? "scroll dense" : "scroll");
  text += ratings_html(report);
  text += table_html(head_to_head_table(report));
  text += table_html(playmakers_table(report, true), "scroll long");
  text += table_html(hosts_table(report));
  text += warnings_html(report);
  text += table_html(failures_table(report), "scroll long");
  text += table_html(matches_table(report, MatchDetails::kLinks), "scroll dense");
  if (!report.matches.empty()) {
    text += "<h2>rerun a match</h2>\n" + text_element("pre", rerun_lines(report));
  }
  return text + fmt::format("</main>\n<footer>cls {}</footer>\n</body>\n</html>\n", base::kVersion);
}

}  // namespace cls::orchestration::tournament
