// Puts head, events, charts, tables and replay together.
#include "viewer/report/report_documents.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/results/results_text.h"
#include "analysis/statistics/statistics_text.h"
#include "base/index.h"
#include "base/system/version.h"
#include "base/text/counted.h"
#include "base/text/xml.h"
#include "soccer/side.h"
#include "viewer/charts/drawing.h"
#include "viewer/page/encoding.h"
#include "viewer/page/viewer_program.h"
#include "viewer/report/report_page.h"

namespace cls::viewer {
namespace {

using analysis::MatchSummary;
using Align = base::Table::Align;

constexpr std::string_view kExpectedGoalsNote =
    "Expected goals are a formula with initial coefficients, not fitted to data: distance, angle "
    "between the posts, speed of the shot, reach of the goalie. They rank chances within a match.";
constexpr std::string_view kLatencyNote =
    "From request to reply: p50 of the median player; p95, p99 and maximum of the slowest one.";

// Text that Markdown shows as it is.
std::string markdown_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\*_`<[|#").find(c) != std::string_view::npos) escaped += '\\';
    escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return escaped;
}

std::string title_of(const MatchSummary& summary) {
  return fmt::format("{} {} {}", team_label(summary, 0), analysis::score_text(summary),
                     team_label(summary, 1));
}

// "202611210102" as "2026-11-21 01:02".
std::string date_text(const std::string& date) {
  if (date.size() != 12) return date;
  return fmt::format("{}-{}-{} {}:{}", date.substr(0, 4), date.substr(4, 2), date.substr(6, 2),
                     date.substr(8, 2), date.substr(10, 2));
}

std::vector<std::string> head_lines(const MatchReport& report) {
  const MatchSummary& summary = report.summary;
  std::string first = base::counted(summary.cycles, "cycle");
  if (summary.past_half) {
    first +=
        fmt::format(", half time {}:{}", summary.teams[0].first_half, summary.teams[1].first_half);
  }
  if (!summary.date.empty()) first += ", " + date_text(summary.date);

  std::vector<std::string> lines = {first};
  if (!summary.file.empty()) lines.push_back(summary.file);
  return lines;
}

// Reasons not to count the match, then the warnings of the match itself.
std::vector<std::string> warning_lines(const MatchReport& report) {
  std::vector<std::string> lines;
  for (const std::string& reason : exclusion_reasons(report.summary, *report.statistics)) {
    lines.push_back("doubt: " + reason);
  }
  lines.insert(lines.end(), report.warnings.begin(), report.warnings.end());
  return lines;
}

std::string player_text(const MatchSummary& summary, soccer::Side side, int unum) {
  const std::string team = team_label(summary, analysis::team_of(side));
  return unum > 0 ? fmt::format("{} {}", team, unum) : team;
}

struct Happening {
  int cycle = 0;
  std::string what;
  std::string who;
  std::string more;
};

Happening goal_row(const MatchSummary& summary, const analysis::MatchStatistics& all,
                   const analysis::Goal& goal) {
  const bool known = goal.scorer != analysis::kNoPlayer;
  const soccer::Side side = known ? analysis::side_of(goal.scorer) : goal.side;
  const int unum = known ? analysis::unum_of(goal.scorer) : 0;

  Happening row{
      goal.cycle, goal.own_goal ? "own goal" : "goal", player_text(summary, side, unum), {}};
  if (goal.shot < 0) return row;

  const std::size_t shot = base::index(goal.shot);
  row.more = fmt::format("from {:.1f} m, {:.2f} xG", all.shots[shot].distance, all.expected[shot]);
  return row;
}

base::Table events_table(const MatchReport& report) {
  const MatchSummary& summary = report.summary;
  std::vector<Happening> rows;
  for (const analysis::Goal& goal : report.statistics->goals) {
    rows.push_back(goal_row(summary, *report.statistics, goal));
  }
  for (const analysis::CardSummary& card : summary.cards) {
    const char* what = card.red ? "red card" : "yellow card";
    rows.push_back({card.cycle, what, player_text(summary, card.side, card.unum), {}});
  }
  for (const analysis::PlayerEvent& one : summary.disconnections) {
    rows.push_back({one.cycle, "disconnected", player_text(summary, one.side, one.unum), {}});
  }

  base::Table table;
  if (rows.empty()) return table;
  std::ranges::stable_sort(rows, {}, &Happening::cycle);
  table.add_column("cycle", Align::kRight);
  table.add_columns({"event", "player", "shot"});
  for (const Happening& row : rows) {
    table.add_row({fmt::to_string(row.cycle), row.what, row.who, row.more});
  }

  return table;
}

std::string latency_text(double microseconds) { return fmt::format("{:.0f} us", microseconds); }

base::Table playmakers_table(const MatchReport& report) {
  base::Table table;
  if (report.playmakers.empty()) return table;

  table.add_columns({"team", "Playmaker"});
  table.add_columns({"decisions", "late", "missed", "p50", "p95", "p99", "max"}, Align::kRight);

  for (const PlaymakerReplies& one : report.playmakers) {
    table.add_row({one.team, one.endpoint, fmt::to_string(one.decisions), fmt::to_string(one.late),
                   fmt::to_string(one.missed), latency_text(one.p50_us), latency_text(one.p95_us),
                   latency_text(one.p99_us), latency_text(one.max_us)});
  }
  return table;
}

std::string policy(bool replay) {
  if (!replay) {
    return fmt::format("default-src 'none'; style-src {} {}; base-uri 'none'; form-action 'none'",
                       csp_hash(report_style()), csp_hash(chart_style()));
  }

  // The frame of the replay inherits this policy.
  return fmt::format(
      "default-src 'none'; script-src {}; style-src {} {} {}; img-src data: blob:; base-uri "
      "'none'; form-action 'none'",
      csp_hash(viewer_script()), csp_hash(report_style()), csp_hash(chart_style()),
      csp_hash(viewer_style()));
}

std::string head_html(const MatchReport& report, bool replay) {
  const std::string title = base::escape_xml(title_of(report.summary));
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{0}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{1}</title>\n<style>{2}</style>\n<style>{3}</style>\n</head>\n<body>\n<main>\n"
      "<header class=\"head\">\n<h1>{1}</h1>\n",
      policy(replay), title, report_style(), chart_style());

  for (const std::string& line : head_lines(report)) text += text_element("p", line);
  if (replay) text += "<p><a href=\"#replay\">Watch the match</a></p>\n";
  return text + "</header>\n";
}

std::string warnings_html(const MatchReport& report) {
  std::string text;
  for (const std::string& line : warning_lines(report)) text += text_element("li", line);
  return text.empty() ? text : "<h2>warnings</h2>\n<ul>\n" + text + "</ul>\n";
}

std::string charts_html(const std::vector<Chart>& charts) {
  if (charts.empty()) return {};
  std::string text = "<h2>charts</h2>\n<div class=\"charts\">\n";
  for (const Chart& chart : charts) text += chart_box(chart.title, chart.svg);
  return text + "</div>\n" + text_element("p", kExpectedGoalsNote, "note");
}

// Quotes stay as they are in an attribute with apostrophes, so read_page() finds the match.
std::string replay_html(const std::string& replay) {
  if (replay.empty()) return {};

  std::string page;
  page.reserve(replay.size() + replay.size() / 16);
  for (const char c : replay) {
    if (c == '&') {
      page += "&amp;";
    } else if (c == '\'') {
      page += "&#39;";
    } else {
      page += c;
    }
  }

  return "<h2 id=\"replay\">replay</h2>\n<iframe title=\"Replay of the match\" srcdoc='" + page +
         "'></iframe>\n";
}

}  // namespace

std::string report_html(const MatchReport& report, const std::vector<Chart>& charts,
                        const std::string& replay) {
  std::string text = head_html(report, !replay.empty());
  text += table_section("goals and cards", events_table(report));
  text += warnings_html(report);
  text += charts_html(charts);

  text += table_section("teams", team_figures(report.summary, *report.statistics));
  text += table_section("players", player_figures(report.summary, *report.statistics), {},
                        "scroll dense");
  text += table_section("Playmakers", playmakers_table(report), kLatencyNote, "scroll long");

  text += replay_html(replay);
  if (!report.command.empty()) {
    text += "<h2>rerun</h2>\n" + commands_box(report.command);
  }
  return text + fmt::format("</main>\n<footer>cls {}</footer>\n</body>\n</html>\n", base::kVersion);
}

std::string report_markdown(const MatchReport& report, const std::vector<Chart>& charts,
                            const std::string& folder) {
  const auto section = [](std::string_view title, const base::Table& table,
                          std::string_view note = {}) {
    if (table.empty()) return std::string();
    return fmt::format("\n## {}\n\n{}{}", title, table.format_markdown(),
                       note.empty() ? "" : fmt::format("\n{}\n", note));
  };

  std::string text = fmt::format("# {}\n\n", markdown_text(title_of(report.summary)));
  for (const std::string& line : head_lines(report)) text += markdown_text(line) + "\n";
  text += section("Goals and cards", events_table(report));

  if (const auto lines = warning_lines(report); !lines.empty()) {
    text += "\n## Warnings\n\n";
    for (const std::string& line : lines) text += fmt::format("- {}\n", markdown_text(line));
  }

  if (!folder.empty() && !charts.empty()) {
    text += "\n## Charts\n";
    for (const Chart& chart : charts) {
      text += fmt::format("\n![{}]({}/{}.svg)\n", markdown_text(chart.title), folder, chart.name);
    }
    text += fmt::format("\n{}\n", kExpectedGoalsNote);
  }

  text += section("Teams", team_figures(report.summary, *report.statistics));
  text += section("Players", player_figures(report.summary, *report.statistics));
  text += section("Playmakers", playmakers_table(report), kLatencyNote);
  if (!report.command.empty()) {
    text += fmt::format("\n## Rerun\n\n```sh\n{}\n```\n", report.command);
  }
  return text;
}

}  // namespace cls::viewer
