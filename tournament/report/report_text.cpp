// Reports as text and Markdown.
#include "tournament/report/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/system/version.h"
#include "base/text/counted.h"
#include "base/text/printable.h"
#include "base/text/wrap_text.h"
#include "process/command_plan.h"
#include "tournament/report/report_bracket.h"
#include "tournament/report/report_tables.h"
#include "tournament/store/match_attempt.h"

namespace cls::tournament {
namespace {

constexpr std::size_t kIndent = 2;
constexpr std::size_t kMaxListed = 40;  // matches or warnings, without TextOptions::all_matches

// Paragraphs, each line indented.
std::string indented(std::string_view text, std::size_t width, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string lines = margin + base::wrap_text(text, width - std::min(width, indent));
  for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 1)) {
    lines.insert(at + 1, margin);
  }
  return lines + '\n';
}

std::string format_text(const ReportTable& table, std::size_t width) {
  std::string text = table.title + "\n";
  text += table.table.format_text({kIndent, width, table.key_columns});
  if (!table.note.empty()) text += indented(table.note, width, kIndent);
  return text;
}

std::string format_markdown(const ReportTable& table) {
  std::string text = fmt::format("## {}\n\n", table.title);
  text += table.table.format_markdown();
  return text + (table.note.empty() ? "" : "\n" + table.note + "\n");
}

// Text of others outside of tables and code: Markdown may contain HTML.
std::string without_markup(std::string_view text) {
  std::string result;
  for (const char c : base::printable(text)) {
    if (c == '<') result += '\\';
    result += c;
  }
  return result;
}

// A shell command in lines that end in a backslash, broken between arguments.
std::string command_text(const TournamentConfig& config, const Fixture& fixture, std::size_t width,
                         std::size_t indent) {
  const process::CommandPlan plan = match_plan(config, fixture, "cls", "");
  std::string text(indent, ' ');
  std::size_t used = indent;
  const auto add = [&](const std::string& word) {
    constexpr std::string_view kContinued = " \\";
    if (used > indent && used + 1 + word.size() + kContinued.size() > width) {
      text += fmt::format("{}\n{:{}}", kContinued, "", indent + 2);
      used = indent + 2;
    } else if (used > indent) {
      text += ' ';
      ++used;
    }
    text += word;
    used += word.size();
  };

  if (!plan.folder.empty()) {
    add("cd");
    add(process::shell_quoted(plan.folder.string()));
    add("&&");
  }
  for (const std::string& argument : plan.argv) add(process::shell_quoted(argument));
  return text + '\n';
}

std::string logs_and_command(const Report& report, const ScheduledMatch& match, std::size_t width) {
  std::string text;
  if (match.outcome && !match.outcome->folder.empty()) {
    text += fmt::format("    logs: {}/\n", (report.link_base / match.outcome->folder).string());
  }
  return text + "    rerun:\n" + command_text(*report.config, match.fixture, width, 6);
}

std::string format_failures(const Report& report, const TextOptions& options) {
  std::string text;
  for (const ScheduledMatch& match : report.matches) {
    if (!failed(match)) continue;
    const Outcome& outcome = *match.outcome;
    const std::string line =
        fmt::format("{} {} - {}: {}{}{}", match.fixture.index, report.team(match.fixture.left),
                    report.team(match.fixture.right), name(outcome.end_reason),
                    outcome.message.empty() ? "" : ", ", outcome.message);
    text += indented(line, options.width, kIndent) + logs_and_command(report, match, options.width);
  }
  return text.empty() ? "" : "\nfailed matches\n" + text;
}

std::string format_warnings(const Report& report, const TextOptions& options) {
  const std::vector<std::string> lines = warning_lines(report);
  if (lines.empty()) return {};
  std::string text = fmt::format("\n{} warnings\n", lines.size());
  const std::size_t listed =
      options.all_matches ? lines.size() : std::min(lines.size(), kMaxListed);
  for (std::size_t i = 0; i < listed; ++i) text += indented(lines[i], options.width, kIndent);
  if (listed < lines.size()) text += "  ... (--matches lists all)\n";
  return text;
}

std::string format_matches(const Report& report, const TextOptions& options) {
  const ReportTable table =
      matches_table(report, options.all_matches ? MatchDetails::kFigures : MatchDetails::kScores);
  if (table.empty()) return {};
  if (!options.all_matches && report.matches.size() > kMaxListed) {
    return fmt::format("\n{} matches (--matches lists them)\n", report.matches.size());
  }
  std::string text = "\n" + format_text(table, options.width);
  if (!options.all_matches) return text;
  text += "\nlogs, and commands that rerun a match\n";
  for (const ScheduledMatch& match : report.matches) {
    text += indented(match_text(report, match), options.width, kIndent);
    text += logs_and_command(report, match, options.width);
  }
  return text;
}

std::string format_endpoints(const Report& report, std::size_t width) {
  std::string text = "\nendpoints\n";
  for (const TeamEntry& team : report.config->competition.teams) {
    text += indented(fmt::format("{}: {}", team.name, team.endpoint), width, kIndent);
  }
  return text;
}

ReportTable crosstable_within(const Report& report, std::size_t width) {
  std::size_t longest = 0;
  for (const TeamEntry& team : report.config->competition.teams)
    longest = std::max(longest, team.name.size());
  const std::size_t columns = report.config->competition.teams.size() + 1;
  return crosstable(report, kIndent + columns * (longest + 2) > width);
}

// Tables between the standings and the matches.
std::vector<ReportTable> middle_tables(const Report& report, ReportTable cross, bool endpoints) {
  std::vector<ReportTable> result;
  for (ReportTable& table :
       std::vector{schedule_table(report), decisions_table(report), pauses_table(report),
                   std::move(cross), head_to_head_table(report), ratings_table(report),
                   playmakers_table(report, endpoints), hosts_table(report)}) {
    if (!table.empty()) result.push_back(std::move(table));
  }
  return result;
}

}  // namespace

std::string schedule_text(const TournamentConfig& config, const Fixture& fixture) {
  std::size_t width = 4;
  for (const TeamEntry& team : config.competition.teams) width = std::max(width, team.name.size());
  const auto team = [&config](int index) { return config.competition.team(index); };
  return fmt::format("{:>3}  {:<8}  {:>{}} - {:<{}}  seed {}{}", fixture.index, stage_text(fixture),
                     team(fixture.left), width, team(fixture.right), width, fixture.seed,
                     fixture.decides ? ", decider" : "");
}

std::string standings_text(const Report& report, const TextOptions& options) {
  std::string text;
  for (const RankedTable& table :
       options.standings_last ? report.tables : tables_by_interest(report)) {
    if (!text.empty()) text += '\n';
    text += format_text(standings_table(report, table, Headings::kShort), options.width);
  }
  return text;
}

std::string winner_text(const Report& report) {
  if (report.tables.empty() || report.counts.finished + report.counts.forfeits == 0) return {};

  const std::vector<std::string> first = first_teams(report);
  if (first.empty()) return {};

  const Standing& best = report.tables.back().standings.front();
  const char* what = report.complete ? "winner" : "leader";
  return fmt::format("{}: {}, {}, goals {}:{}\n", first.size() > 1 ? "level" : what,
                     fmt::join(first, " and "), base::counted(best.points, "point"), best.goals_for,
                     best.goals_against);
}

std::string report_text(const Report& report, const TextOptions& options) {
  const std::size_t width = options.width;
  std::string text = base::wrap_text(report.name + ": " + headline(report), width) + "\n";
  for (const std::string& line : head_lines(report)) text += base::wrap_text(line, width) + "\n";

  const std::string standings = "\n" + standings_text(report, options);
  if (!options.standings_last) text += standings;
  if (const std::string tree = bracket_text(report, width - kIndent); !tree.empty()) {
    text += "\nbracket\n" + indented(tree.substr(0, tree.size() - 1), width, kIndent);
  }

  for (const ReportTable& table : middle_tables(report, crosstable_within(report, width), false)) {
    text += "\n" + format_text(table, width);
  }

  text += format_endpoints(report, width) + format_warnings(report, options) +
          format_matches(report, options) + format_failures(report, options);
  if (!options.standings_last) return base::printable_lines(text);
  return base::printable_lines(text + standings + "\n" + winner_text(report));
}

std::string report_markdown(const Report& report) {
  constexpr std::size_t kTreeWidth = 120;
  std::string text = fmt::format("# {}\n\n{}\n", without_markup(report.name), headline(report));
  for (const std::string& line : head_lines(report)) {
    text += fmt::format("{}\n", without_markup(line));
  }

  for (const RankedTable& ranked : tables_by_interest(report)) {
    text += "\n" + format_markdown(standings_table(report, ranked, Headings::kLong));
  }
  if (const std::string tree = bracket_text(report, kTreeWidth); !tree.empty()) {
    text += fmt::format("\n## bracket\n\n```text\n{}```\n", tree);
  }

  std::vector<ReportTable> tables = middle_tables(report, crosstable(report, false), true);
  for (ReportTable& table :
       std::vector{matches_table(report, MatchDetails::kLinks), failures_table(report)}) {
    if (!table.empty()) tables.push_back(std::move(table));
  }
  for (const ReportTable& table : tables) text += "\n" + format_markdown(table);

  if (const auto warnings = warning_lines(report); !warnings.empty()) {
    text += fmt::format("\n## {} warnings\n\n```text\n{}\n```\n", warnings.size(),
                        fmt::join(warnings, "\n"));
  }
  if (!report.matches.empty()) {
    text += fmt::format("\n## Rerun a match\n\n```sh\n{}```\n", rerun_lines(report));
  }
  return base::printable_lines(text);
}

}  // namespace cls::tournament
