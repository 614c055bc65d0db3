// Reports as text, Markdown and HTML.
#include "orchestration/tournament/report/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/system/version.h"
#include "base/text/wrap_text.h"
#include "base/text/xml.h"
#include "orchestration/tournament/report/report_tables.h"

namespace cls::orchestration::tournament {
namespace {

constexpr std::size_t kTextWidth = 78;
constexpr std::size_t kIndent = 2;
constexpr base::MarkdownStyle kMarkdown = {"|", "|", "---:"};

std::string format_text(const ReportTable& table) {
  std::string text = table.title.empty() ? "" : table.title + "\n";
  text += table.table.format_text(kIndent);
  if (!table.note.empty()) text += base::wrap_text(table.note, kTextWidth) + "\n";
  return text;
}

std::string format_markdown(const ReportTable& table) {
  std::string text = table.title.empty() ? "" : fmt::format("## {}\n\n", table.title);
  text += table.table.format_markdown(kMarkdown);
  return text + (table.note.empty() ? "" : "\n" + table.note + "\n");
}

std::string format_html(const ReportTable& table) {
  const auto element = [](const char* tag, const std::string& text) {
    return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", tag, base::escape_xml(text));
  };
  return element("h2", table.title) + table.table.format_html() + element("p", table.note);
}

std::string format_failures(const Report& report) {
  std::string text;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome || match.outcome->played()) continue;
    const Outcome& outcome = *match.outcome;
    fmt::format_to(std::back_inserter(text), "  {} {} - {}: {}{}{}\n", match.fixture.index,
                   report.team(match.fixture.left), report.team(match.fixture.right),
                   name(outcome.end_reason), outcome.message.empty() ? "" : ", ", outcome.message);
    if (!outcome.folder.empty()) {
      text += fmt::format("    logs: {}/\n", (report.folder / outcome.folder).string());
    }
    text += fmt::format("    rerun: {}\n", rerun_command(*report.config, match.fixture));
  }
  return text.empty() ? "" : "\nfailed matches\n" + text;
}

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em;"
    "color:#1b1b1b;background:#fff}"
    "table{border-collapse:collapse;margin:.5em 0 1.5em;display:block;overflow-x:auto}"
    "th,td{padding:.2em .8em;text-align:right;border-bottom:1px solid #d8d8d8;"
    "font-variant-numeric:tabular-nums}"
    "th{border-bottom:2px solid #888}.w{text-align:left}"
    "@media(prefers-color-scheme:dark){body{color:#e6e6e6;background:#161616}"
    "th,td{border-color:#444}}";

}  // namespace

std::string schedule_text(const TournamentConfig& config, const Fixture& fixture) {
  std::size_t width = 4;
  for (const TeamEntry& team : config.teams) width = std::max(width, team.name.size());
  const auto team = [&config](int index) {
    return config.teams[static_cast<std::size_t>(index)].name;
  };
  return fmt::format("{:>6}  round {:<3} {:>{}} - {:<{}}  seed {}{}{}", fixture.index,
                     fixture.round, team(fixture.left), width, team(fixture.right), width,
                     fixture.seed, fixture.stage.empty() ? "" : "  " + fixture.stage,
                     fixture.decides ? ", decider" : "");
}

std::string standings_text(const Report& report) {
  std::string text;
  for (const RankedTable& table : report.tables) {
    if (!text.empty()) text += '\n';
    text += format_text(standings_table(report, table));
  }
  return text;
}

std::string report_text(const Report& report) {
  std::string text = headline(report) + "\n";
  for (const ReportTable& table : report_tables(report)) text += "\n" + format_text(table);
  return text + format_failures(report);
}

std::string report_markdown(const Report& report) {
  std::string text = fmt::format("# Tournament\n\n{}\n", headline(report));
  for (const ReportTable& table : report_tables(report)) text += "\n" + format_markdown(table);
  const ReportTable failures = failures_table(report);
  return failures.empty() ? text : text + "\n" + format_markdown(failures);
}

std::string report_html(const Report& report) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Tournament: {}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>Tournament</h1>\n"
      "<p>{}</p>\n",
      base::escape_xml(name(report.config->format)), kStyle, base::escape_xml(headline(report)));
  std::vector<ReportTable> tables = report_tables(report);
  tables.push_back(failures_table(report));
  tables.push_back(matches_table(report));
  for (const ReportTable& table : tables) {
    if (!table.empty()) text += format_html(table);
  }
  return text + fmt::format("<p>cls {}</p>\n</body>\n</html>\n", base::kVersion);
}

}  // namespace cls::orchestration::tournament
