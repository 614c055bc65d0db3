// Grids as text, Markdown and HTML.
#include "orchestration/tournament/report/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/system/version.h"
#include "base/text/wrapped_text.h"
#include "base/text/xml.h"
#include "orchestration/tournament/report/report_grid.h"

namespace cls::orchestration::tournament {
namespace {

constexpr std::size_t kTextWidth = 78;

bool is_word(const Grid& grid, std::size_t column) {
  return std::find(grid.words.begin(), grid.words.end(), column) != grid.words.end();
}

std::string as_text(const Grid& grid) {
  std::vector<std::size_t> width;
  for (const auto& row : grid.rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  std::string text = grid.title.empty() ? "" : grid.title + "\n";
  for (const auto& row : grid.rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += is_word(grid, i) ? fmt::format("  {:<{}}", row[i], width[i])
                               : fmt::format("  {:>{}}", row[i], width[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  if (!grid.note.empty()) text += base::wrapped(grid.note, kTextWidth) + "\n";
  return text;
}

std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string as_markdown(const Grid& grid) {
  std::string text = grid.title.empty() ? "" : fmt::format("## {}\n\n", grid.title);
  for (std::size_t r = 0; r < grid.rows.size(); ++r) {
    for (const std::string& cell : grid.rows[r]) text += fmt::format("| {} ", markdown_cell(cell));
    text += "|\n";
    if (r > 0) continue;
    for (std::size_t i = 0; i < grid.rows[0].size(); ++i) {
      text += is_word(grid, i) ? "|---" : "|---:";
    }
    text += "|\n";
  }
  return text + (grid.note.empty() ? "" : "\n" + grid.note + "\n");
}

std::string as_html(const Grid& grid) {
  std::string text =
      grid.title.empty() ? "" : fmt::format("<h2>{}</h2>\n", base::xml_escaped(grid.title));
  text += "<table>\n";
  for (std::size_t r = 0; r < grid.rows.size(); ++r) {
    const char* tag = r == 0 ? "th" : "td";
    text += "<tr>";
    for (std::size_t i = 0; i < grid.rows[r].size(); ++i) {
      text += fmt::format("<{}{}>{}</{}>", tag, is_word(grid, i) ? " class=\"w\"" : "",
                          base::xml_escaped(grid.rows[r][i]), tag);
    }
    text += "</tr>\n";
  }
  text += "</table>\n";
  return text + (grid.note.empty() ? "" : fmt::format("<p>{}</p>\n", base::xml_escaped(grid.note)));
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
                     fixture.decides ? ", to a decision" : "");
}

std::string standings_text(const Report& report) {
  std::string text;
  for (const RankedTable& table : report.tables) {
    if (!text.empty()) text += '\n';
    text += as_text(standings_grid(report, table));
  }
  return text;
}

std::string report_text(const Report& report) {
  std::string text = headline(report) + "\n";
  for (const Grid& grid : report_grids(report)) text += "\n" + as_text(grid);
  const Grid failures = failures_grid(report);
  if (!failures.rows.empty()) text += "\nfailed matches\n";
  for (std::size_t i = 1; i < failures.rows.size(); ++i) {
    const auto& row = failures.rows[i];
    fmt::format_to(std::back_inserter(text), "  {} {} - {}: {}{}{}\n{}    again: {}\n", row[0],
                   row[1], row[2], row[3], row[4].empty() ? "" : ", ", row[4],
                   row[5].empty() ? "" : fmt::format("    logs: {}/\n", row[5]), row[6]);
  }
  return text;
}

std::string report_markdown(const Report& report) {
  std::string text = fmt::format("# Tournament\n\n{}\n", headline(report));
  for (const Grid& grid : report_grids(report)) text += "\n" + as_markdown(grid);
  const Grid failures = failures_grid(report);
  return failures.rows.empty() ? text : text + "\n" + as_markdown(failures);
}

std::string report_html(const Report& report) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>Tournament: {}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>Tournament</h1>\n"
      "<p>{}</p>\n",
      base::xml_escaped(name(report.config->format)), kStyle, base::xml_escaped(headline(report)));
  std::vector<Grid> grids = report_grids(report);
  grids.push_back(failures_grid(report));
  grids.push_back(matches_grid(report));
  for (const Grid& grid : grids) {
    if (!grid.rows.empty()) text += as_html(grid);
  }
  return text + fmt::format("<p>cls {}</p>\n</body>\n</html>\n", base::kVersion);
}

}  // namespace cls::orchestration::tournament
