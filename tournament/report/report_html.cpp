// The page and its style.
#include "tournament/report/report_html.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "base/system/version.h"
#include "base/text/xml.h"
#include "tournament/report/report_bracket.h"
#include "tournament/report/report_charts.h"
#include "tournament/report/report_tables.h"
#include "viewer/charts/drawing.h"
#include "viewer/report/report_page.h"

namespace cls::tournament {
namespace {

using viewer::text_element;

std::string table_html(const ReportTable& table, std::string_view kind = "scroll") {
  return viewer::table_section(table.title, table.table, table.note, kind);
}

std::string ratings_html(const Report& report) {
  const ReportTable table = ratings_table(report);
  if (table.empty()) return {};
  return text_element("h2", table.title) + viewer::chart_box(table.title, ratings_chart(report)) +
         viewer::table_box(table.title, table.table) + text_element("p", table.note, "note");
}

std::string differences_html(const Report& report) {
  const std::vector<std::string> charts = differences_charts(report);
  if (charts.empty()) return {};
  // A grid is as wide as the page; one chart is not.
  std::string text = text_element("h2", "goal differences");
  text += charts.size() == 1 ? "<div>\n" : "<div class=\"charts\">\n";
  for (std::size_t i = 0; i < charts.size(); ++i) {
    text += viewer::chart_box(fmt::format("goal differences {}", i + 1), charts[i]);
  }
  return text + "</div>\n";
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
      "<title>{0}</title>\n<style>{1}{2}{3}</style>\n</head>\n<body>\n<main>\n"
      "<header class=\"head\">\n<h1>{0}</h1>\n",
      base::escape_xml(report.name), viewer::report_style(), viewer::chart_style(), kBracketStyle);
  text += text_element("p", headline(report), "state");
  for (const std::string& line : head_lines(report)) text += text_element("p", line);
  return text + "</header>\n";
}

}  // namespace

std::string report_html(const Report& report) {
  constexpr std::size_t kMaxNamedColumns = 8;
  std::string text = head_html(report);
  for (const RankedTable& ranked : tables_by_interest(report)) {
    text += table_html(standings_table(report, ranked, Headings::kLong));
  }

  if (!report.bracket.empty()) text += "<h2>bracket</h2>\n" + bracket_html(report);
  text += table_html(schedule_table(report));
  text += table_html(decisions_table(report));
  text += table_html(pauses_table(report));

  const bool numbered = report.config->competition.teams.size() > kMaxNamedColumns;
  text += table_html(crosstable(report, numbered), numbered ? "scroll dense" : "scroll");

  text += ratings_html(report);
  text += table_html(head_to_head_table(report));
  text += differences_html(report);

  text += table_html(playmakers_table(report, true), "scroll long");
  text += table_html(hosts_table(report));
  text += warnings_html(report);
  text += table_html(failures_table(report), "scroll long");
  text += table_html(matches_table(report, MatchDetails::kLinks), "scroll dense");

  if (!report.matches.empty()) {
    text += "<h2>rerun a match</h2>\n" + viewer::commands_box(rerun_lines(report));
  }
  return text + fmt::format("</main>\n<footer>cls {}</footer>\n</body>\n</html>\n", base::kVersion);
}

}  // namespace cls::tournament
