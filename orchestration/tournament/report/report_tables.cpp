// Columns and rows of the report tables.
#include "orchestration/tournament/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cls::orchestration::tournament {
namespace {

using Align = base::Table::Align;

std::string percent(const Estimate& strength) {
  if (strength.count == 0) return "-";
  return fmt::format("{:.1f}", 100 * strength.score);
}

std::string percent_interval(const Estimate& strength) {
  if (strength.count == 0) return "-";
  return fmt::format("{:.1f}..{:.1f}", 100 * strength.score_interval.low,
                     100 * strength.score_interval.high);
}

std::string superiority(double likelihood) { return fmt::format("{:.1f} %", 100 * likelihood); }

std::string counted(int number, const char* one, const char* many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string sample_text(const HeadToHead& head_to_head) {
  if (!head_to_head.paired()) return counted(head_to_head.games.games(), "match", "matches");
  std::string text = counted(static_cast<int>(total(head_to_head.pairs)), "pair", "pairs");
  if (head_to_head.single_games > 0)
    text += fmt::format(", not {} single", head_to_head.single_games);
  return text;
}

std::string goals(int goals_for, int goals_against) {
  return fmt::format("{}:{}", goals_for, goals_against);
}

}  // namespace

std::string headline(const Report& report) {
  const TournamentConfig& config = *report.config;
  return fmt::format("{} of {} teams, seed {}: {}", name(config.format), config.teams.size(),
                     config.seed, counts_text(report.counts));
}

ReportTable standings_table(const Report& report, const RankedTable& ranked) {
  const bool swiss = report.config->format == Format::kSwiss;
  const bool separated = std::any_of(ranked.standings.begin(), ranked.standings.end(),
                                     [](const Standing& row) { return !row.separated_by.empty(); });
  ReportTable result;
  result.title = ranked.title;
  base::Table& table = result.table;
  table.add_column("#", Align::kRight);
  table.add_column("team");
  table.add_columns(
      {"played", "won", "drawn", "lost", "goals", "diff", "points", "score %", "95 %"},
      Align::kRight);
  if (swiss) table.add_column("buchholz", Align::kRight);
  if (separated) table.add_column("");
  for (const Standing& row : ranked.standings) {
    const Estimate strength = strength_of(report.records[static_cast<std::size_t>(row.team)]);
    std::vector<std::string> cells = {fmt::to_string(row.rank),
                                      report.team(row.team),
                                      fmt::to_string(row.played),
                                      fmt::to_string(row.won),
                                      fmt::to_string(row.drawn),
                                      fmt::to_string(row.lost),
                                      goals(row.goals_for, row.goals_against),
                                      fmt::format("{:+}", row.goal_difference()),
                                      fmt::to_string(row.points),
                                      percent(strength),
                                      percent_interval(strength)};
    if (swiss) cells.push_back(fmt::format("{}", row.buchholz));
    if (separated) cells.push_back(row.separated_by.empty() ? "" : "by " + row.separated_by);
    table.add_row(std::move(cells));
  }
  return result;
}

ReportTable crosstable(const Report& report) {
  const int teams = static_cast<int>(report.config->teams.size());
  ReportTable result;
  if (teams < 3 || teams > 20) return result;
  result.title = "won-drawn-lost, row against column";
  base::Table& table = result.table;
  table.add_column("");
  for (int team = 0; team < teams; ++team) table.add_column(report.team(team), Align::kRight);
  for (int row = 0; row < teams; ++row) {
    std::vector<std::string> cells = {report.team(row)};
    for (int column = 0; column < teams; ++column) {
      const auto head_to_head = find_head_to_head(report, row, column);
      cells.push_back(!head_to_head
                          ? "."
                          : fmt::format("{}-{}-{}", head_to_head->games.won,
                                        head_to_head->games.drawn, head_to_head->games.lost));
    }
    table.add_row(std::move(cells));
  }
  return result;
}

ReportTable head_to_head_table(const Report& report) {
  constexpr std::size_t kMaxRows = 40;
  ReportTable result;
  if (report.head_to_heads.empty() || report.head_to_heads.size() > kMaxRows) return result;
  result.title = "team against opponent";
  result.note =
      "Elo: of the team against the opponent, with its 95 % interval. Better: likelihood that the "
      "team is the better one. Both from pairs where there are any, else from single matches.";
  base::Table& table = result.table;
  table.add_columns({"team", "opponent"});
  table.add_columns({"W-D-L", "goals", "score %", "95 %", "Elo", "95 %", "better"}, Align::kRight);
  table.add_column("from");
  for (const HeadToHead& head_to_head : report.head_to_heads) {
    const Estimate strength = head_to_head.strength();
    table.add_row(
        {report.team(head_to_head.first), report.team(head_to_head.second),
         fmt::format("{}-{}-{}", head_to_head.games.won, head_to_head.games.drawn,
                     head_to_head.games.lost),
         goals(head_to_head.goals_for, head_to_head.goals_against), percent(strength),
         percent_interval(strength), fmt::format("{:+.0f}", strength.elo),
         fmt::format("{:+.0f}..{:+.0f}", strength.elo_interval.low, strength.elo_interval.high),
         superiority(strength.superiority), sample_text(head_to_head)});
  }
  return result;
}

ReportTable ratings_table(const Report& report) {
  ReportTable result;
  const std::size_t teams = report.config->teams.size();
  if (teams < 3 || report.head_to_heads.empty()) return result;
  std::vector<std::size_t> order;  // without teams that have only forfeits
  for (std::size_t team = 0; team < teams; ++team) {
    if (report.records[team].games() > 0) order.push_back(team);
  }
  const Ratings& ratings = report.ratings;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ratings.elo[a] > ratings.elo[b]; });
  result.title = "rating";
  result.note =
      "Bradley-Terry over all matches; 0 is the mean of the teams. Better: likelihood that the "
      "team is better than the next one.";
  base::Table& table = result.table;
  table.add_column("team");
  table.add_columns({"Elo", "+- 95 %", "better", "matches"}, Align::kRight);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t team = order[i];
    table.add_row({report.team(static_cast<int>(team)), fmt::format("{:+.0f}", ratings.elo[team]),
                   fmt::format("{:.0f}", ratings.error[team]),
                   i + 1 < order.size() ? superiority(ratings.superiority[team][order[i + 1]]) : "",
                   fmt::to_string(report.records[team].games())});
  }
  return result;
}

ReportTable failures_table(const Report& report) {
  ReportTable result;
  base::Table& table = result.table;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome || match.outcome->played()) continue;
    const Outcome& outcome = *match.outcome;
    if (table.empty()) {
      result.title = "failed matches";
      table.add_column("match", Align::kRight);
      table.add_columns({"left", "right", "end reason", "message", "logs", "rerun"});
    }
    table.add_row({fmt::to_string(match.fixture.index), report.team(match.fixture.left),
                   report.team(match.fixture.right), std::string(name(outcome.end_reason)),
                   outcome.message,
                   outcome.folder.empty() ? "" : (report.folder / outcome.folder).string(),
                   rerun_command(*report.config, match.fixture)});
  }
  return result;
}

ReportTable matches_table(const Report& report) {
  ReportTable result;
  result.title = "matches";
  base::Table& table = result.table;
  table.add_column("match", Align::kRight);
  table.add_columns({"stage", "left", "right"});
  table.add_columns({"score", "seed"}, Align::kRight);
  table.add_column("host");
  table.add_column("cycles/s", Align::kRight);
  for (const ScheduledMatch& match : report.matches) {
    const Fixture& fixture = match.fixture;
    table.add_row({fmt::to_string(fixture.index),
                   fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage,
                   report.team(fixture.left), report.team(fixture.right), score_text(match),
                   fmt::to_string(fixture.seed), match.outcome ? match.outcome->host : "",
                   match.outcome ? fmt::format("{:.0f}", match.outcome->cycles_per_second) : ""});
  }
  return result;
}

std::vector<ReportTable> report_tables(const Report& report) {
  std::vector<ReportTable> result;
  for (const RankedTable& ranked : report.tables) {
    result.push_back(standings_table(report, ranked));
  }
  for (ReportTable& table :
       std::vector{crosstable(report), head_to_head_table(report), ratings_table(report)}) {
    if (!table.empty()) result.push_back(std::move(table));
  }
  return result;
}

}  // namespace cls::orchestration::tournament
