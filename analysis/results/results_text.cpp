// Formats result tables as text, Markdown and CSV.
#include "analysis/results/results_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/results/team_table.h"
#include "base/index.h"
#include "base/text/table.h"

namespace cls::analysis {
namespace {

using Align = base::Table::Align;

template <typename Event, typename Extra>
std::string list_of(const std::vector<Event>& events, Extra extra) {
  std::string text;
  for (const Event& event : events) {
    if (!text.empty()) text += "; ";
    text += fmt::format("{} {} {}{}", event.cycle, soccer::letter(event.side),
                        event.unum == 0 ? "?" : std::to_string(event.unum), extra(event));
  }
  return text;
}

std::string goals_text(const MatchSummary& match) {
  return list_of(match.goals, [](const GoalSummary& goal) { return goal.own_goal ? " own" : ""; });
}

std::string cards_text(const MatchSummary& match) {
  return list_of(match.cards, [](const CardSummary& card) { return card.red ? " red" : ""; });
}

std::string substitutions_text(const MatchSummary& match) {
  return list_of(match.substitutions, [](const SubstitutionSummary& change) {
    return fmt::format(" {}>{}", change.from_type, change.to_type);
  });
}

std::string players_text(const std::vector<PlayerEvent>& events) {
  return list_of(events, [](const PlayerEvent&) { return ""; });
}

std::string name_of(const TeamSummary& team) { return team.name.empty() ? "-" : team.name; }

std::string winner_text(const MatchSummary& match) {
  if (match.winner == Winner::kNone) return "incomplete";
  if (match.winner == Winner::kDraw) return "draw";
  return name_of(match.teams[match.winner == Winner::kRight ? 1 : 0]);
}

// Counts of rare events; CSV and JSON list them.
std::string remarks_text(const MatchSummary& match) {
  std::string text;
  const auto add = [&text](std::size_t count, std::string_view what) {
    if (count == 0) return;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", count, what);
  };

  const std::size_t red = base::index(std::ranges::count(match.cards, true, &CardSummary::red));
  if (match.coin_toss) text = "coin toss";

  add(match.cards.size() - red, "yellow");
  add(red, "red");
  add(match.substitutions.size(), "substituted");
  add(match.disconnections.size(), "disconnected");
  add(match.late_starts.size(), "connected late");
  add(match.never_connected.size(), "never connected");
  add(match.parse_errors, match.parse_errors == 1 ? "parse error" : "parse errors");

  if (!match.complete && !match.end_reason.empty()) {
    text = match.end_reason + (text.empty() ? "" : ", ") + text;
  }
  return text;
}

// File names; if two are equal, paths without their common folders, and without the file name if
// all logs have the same.
std::vector<std::string> short_names(const std::vector<MatchSummary>& matches) {
  std::vector<std::string> names;
  std::set<std::string> distinct;
  std::set<std::string> folders;
  std::string shared = matches.empty() ? "" : matches.front().file;

  for (const MatchSummary& match : matches) {
    names.push_back(match.file.substr(match.file.rfind('/') + 1));
    distinct.insert(names.back());
    folders.insert(match.file.substr(0, match.file.size() - names.back().size()));
    shared.erase(std::ranges::mismatch(shared, match.file).in1, shared.end());
  }

  if (distinct.size() == names.size()) return names;
  const std::size_t start = shared.rfind('/') + 1;
  const bool by_folder = distinct.size() == 1 && folders.size() == names.size();

  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = matches[i].file.substr(start);
    if (by_folder) names[i].resize(names[i].rfind('/'));
  }
  return names;
}

base::Table markdown_table(const std::vector<MatchSummary>& matches) {
  base::Table table;
  table.add_column("left");
  table.add_column("score", Align::kRight);
  table.add_columns({"right", "winner"});
  table.add_column("cycles", Align::kRight);
  table.add_columns({"goals", "remarks", "log"});

  const std::vector<std::string> names = short_names(matches);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MatchSummary& match = matches[i];
    table.add_row({name_of(match.teams[0]), score_text(match), name_of(match.teams[1]),
                   winner_text(match), std::to_string(match.cycles), goals_text(match),
                   remarks_text(match), names[i]});
  }
  return table;
}

// The score shows the winner, so the remarks name one only after a coin toss.
std::string all_remarks(const MatchSummary& match) {
  std::string text = remarks_text(match);
  if (match.coin_toss) text.insert(std::string_view("coin toss").size(), ": " + winner_text(match));
  if (match.winner == Winner::kNone) text = "incomplete" + (text.empty() ? "" : ", " + text);
  return text;
}

// A row per match that fits in a line: without the winner, without remarks if there are none.
base::Table text_table(const std::vector<MatchSummary>& matches) {
  const bool remarks = std::ranges::any_of(
      matches, [](const MatchSummary& match) { return !all_remarks(match).empty(); });

  base::Table table;
  table.add_column("left");
  table.add_column("score", Align::kRight);
  table.add_column("right");
  table.add_column("cycles", Align::kRight);
  table.add_column("goals");
  if (remarks) table.add_column("remarks");
  table.add_column("log");
  for (std::size_t column = 4; column < (remarks ? 7 : 6); ++column) table.allow_cuts(column);

  const std::vector<std::string> names = short_names(matches);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MatchSummary& match = matches[i];
    std::vector<std::string> cells = {name_of(match.teams[0]), score_text(match),
                                      name_of(match.teams[1]), std::to_string(match.cycles),
                                      goals_text(match)};
    if (remarks) cells.push_back(all_remarks(match));
    cells.push_back(names[i]);
    table.add_row(std::move(cells));
  }
  return table;
}

std::string penalties_text(const MatchSummary& match, std::size_t team) {
  return match.penalties ? std::to_string(match.teams[team].penalty_score) : "";
}

struct CsvColumn {
  std::string_view heading;
  std::string (*text)(const MatchSummary& m);
};

// clang-format off
constexpr CsvColumn kCsvColumns[] = {
    {"file", [](auto& m) { return m.file; }},
    {"date", [](auto& m) { return m.date; }},
    {"version", [](auto& m) { return m.version; }},
    {"left", [](auto& m) { return m.teams[0].name; }},
    {"right", [](auto& m) { return m.teams[1].name; }},
    {"left_score", [](auto& m) { return std::to_string(m.teams[0].score); }},
    {"right_score", [](auto& m) { return std::to_string(m.teams[1].score); }},
    {"left_penalties", [](auto& m) { return penalties_text(m, 0); }},
    {"right_penalties", [](auto& m) { return penalties_text(m, 1); }},
    {"winner", [](auto& m) { return std::string(winner_name(m.winner)); }},
    {"complete", [](auto& m) { return std::string(m.complete ? "true" : "false"); }},
    {"cycles", [](auto& m) { return std::to_string(m.cycles); }},
    {"goals", goals_text},
    {"cards", cards_text},
    {"substitutions", substitutions_text},
    {"disconnections", [](auto& m) { return players_text(m.disconnections); }},
    {"late_starts", [](auto& m) { return players_text(m.late_starts); }},
    {"never_connected", [](auto& m) { return players_text(m.never_connected); }},
    {"damage", [](auto& m) { return std::to_string(m.parse_errors); }},
    {"end_reason", [](auto& m) { return m.end_reason; }},
};
// clang-format on

base::Table csv_table(const std::vector<MatchSummary>& matches) {
  base::Table table;
  for (const CsvColumn& column : kCsvColumns) table.add_column(std::string(column.heading));
  for (const MatchSummary& match : matches) {
    std::vector<std::string> cells;
    for (const CsvColumn& column : kCsvColumns) cells.push_back(column.text(match));
    table.add_row(std::move(cells));
  }
  return table;
}

base::Table team_table_text(const TeamTable& standings) {
  base::Table table;
  table.add_column("team");
  table.add_columns({"played", "won", "drawn", "lost", "goals", "difference", "points"},
                    Align::kRight);

  for (const TeamResults& row : standings.rows) {
    table.add_row({row.team, std::to_string(row.played), std::to_string(row.won),
                   std::to_string(row.drawn), std::to_string(row.lost),
                   fmt::format("{}:{}", row.goals_for, row.goals_against),
                   fmt::format("{:+}", row.goal_difference()), std::to_string(row.points)});
  }
  return table;
}

}  // namespace

std::string score_text(const MatchSummary& match) {
  const auto& [left, right] = match.teams;
  std::string text = fmt::format("{}:{}", left.score, right.score);
  if (match.penalties) {
    text += fmt::format(" ({}:{} pen.)", left.penalty_score, right.penalty_score);
  }
  return text;
}

std::string format_results(const std::vector<MatchSummary>& matches, ResultsFormat format,
                           std::size_t width) {
  if (format == ResultsFormat::kJson) return results_json(matches);
  if (format == ResultsFormat::kCsv) return csv_table(matches).format_csv();

  const bool markdown = format == ResultsFormat::kMarkdown;
  constexpr std::size_t kKeyColumns = 3;  // teams and score
  std::string text = markdown ? markdown_table(matches).format_markdown()
                              : text_table(matches).format_text({0, width, kKeyColumns});

  const TeamTable standings = team_table(matches);
  if (matches.size() > 1 && !standings.rows.empty()) {
    const base::Table teams = team_table_text(standings);
    text += '\n';
    text += markdown ? teams.format_markdown() : teams.format_text({0, width});
    if (standings.not_counted > 0) {
      text += fmt::format("\n{} incomplete not counted\n", standings.not_counted);
    }
  }
  return text;
}

}  // namespace cls::analysis
