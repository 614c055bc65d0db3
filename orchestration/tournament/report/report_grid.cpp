// Cells.
#include "orchestration/tournament/report/report_grid.h"

#include <fmt/format.h>

#include <algorithm>

namespace cls::orchestration::tournament {
namespace {

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

std::string sample_text(const Duel& duel) {
  if (!duel.paired()) return counted(duel.games.games(), "match", "matches");
  std::string text = counted(static_cast<int>(total(duel.pairs)), "pair", "pairs");
  if (duel.single_games > 0) text += fmt::format(", not {} single", duel.single_games);
  return text;
}

std::string goals(int goals_for, int goals_against) {
  return fmt::format("{}:{}", goals_for, goals_against);
}

}  // namespace

std::string headline(const Report& report) {
  const MatchCounts& counts = report.counts;
  const TournamentConfig& config = *report.config;
  std::string text =
      fmt::format("{} of {} teams, seed {}: {} of {} matches done", name(config.format),
                  config.teams.size(), config.seed, counts.done(), counts.scheduled);
  if (counts.forfeits > 0) text += fmt::format(", {} forfeited", counts.forfeits);
  if (counts.invalid > 0) text += fmt::format(", {} INVALID", counts.invalid);
  return text;
}

Grid standings_grid(const Report& report, const RankedTable& table) {
  const bool swiss = report.config->format == Format::kSwiss;
  Grid grid;
  grid.title = table.title;
  grid.words = {1};
  grid.rows = {{"#", "team", "played", "won", "drawn", "lost", "goals", "diff", "points", "score %",
                "95 %"}};
  if (swiss) grid.rows.front().push_back("buchholz");
  const bool separated = std::any_of(table.standings.begin(), table.standings.end(),
                                     [](const Standing& row) { return !row.separated_by.empty(); });
  if (separated) {
    grid.rows.front().push_back("");
    grid.words.push_back(grid.rows.front().size() - 1);
  }
  for (const Standing& row : table.standings) {
    const Estimate strength = strength_of(report.records[static_cast<std::size_t>(row.team)]);
    grid.rows.push_back(
        {fmt::to_string(row.rank), report.team(row.team), fmt::to_string(row.played),
         fmt::to_string(row.won), fmt::to_string(row.drawn), fmt::to_string(row.lost),
         goals(row.goals_for, row.goals_against), fmt::format("{:+}", row.goal_difference()),
         fmt::to_string(row.points), percent(strength), percent_interval(strength)});
    if (swiss) grid.rows.back().push_back(fmt::format("{}", row.buchholz));
    if (!separated) continue;
    grid.rows.back().push_back(row.separated_by.empty() ? "" : "by " + row.separated_by);
  }
  return grid;
}

Grid crosstable_grid(const Report& report) {
  const int teams = static_cast<int>(report.config->teams.size());
  Grid grid;
  if (teams < 3 || teams > 20) return grid;
  grid.title = "won-drawn-lost, row against column";
  grid.words = {0};
  grid.rows.push_back({""});
  for (int column = 0; column < teams; ++column) grid.rows[0].push_back(report.team(column));
  for (int row = 0; row < teams; ++row) {
    grid.rows.push_back({report.team(row)});
    for (int column = 0; column < teams; ++column) {
      const auto duel = find_duel(report, row, column);
      grid.rows.back().push_back(
          !duel ? "."
                : fmt::format("{}-{}-{}", duel->games.won, duel->games.drawn, duel->games.lost));
    }
  }
  return grid;
}

Grid duels_grid(const Report& report) {
  constexpr std::size_t kMost = 40;
  Grid grid;
  if (report.duels.empty() || report.duels.size() > kMost) return grid;
  grid.title = "team against opponent";
  grid.note =
      "Elo: of the team against the opponent, with its 95 % interval. Better: likelihood that the "
      "team is the better one. Both from pairs where there are any, else from single matches.";
  grid.words = {0, 1, 9};
  grid.rows = {
      {"team", "opponent", "W-D-L", "goals", "score %", "95 %", "Elo", "95 %", "better", "from"}};
  for (const Duel& duel : report.duels) {
    const Estimate strength = duel.strength();
    grid.rows.push_back(
        {report.team(duel.first), report.team(duel.second),
         fmt::format("{}-{}-{}", duel.games.won, duel.games.drawn, duel.games.lost),
         goals(duel.goals_for, duel.goals_against), percent(strength), percent_interval(strength),
         fmt::format("{:+.0f}", strength.elo),
         fmt::format("{:+.0f}..{:+.0f}", strength.elo_interval.low, strength.elo_interval.high),
         superiority(strength.superiority), sample_text(duel)});
  }
  return grid;
}

Grid ratings_grid(const Report& report) {
  Grid grid;
  const std::size_t teams = report.config->teams.size();
  if (teams < 3 || report.duels.empty()) return grid;
  std::vector<std::size_t> order;  // nothing is known of a team that has only forfeits
  for (std::size_t team = 0; team < teams; ++team) {
    if (report.records[team].games() > 0) order.push_back(team);
  }
  const Ratings& ratings = report.ratings;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ratings.elo[a] > ratings.elo[b]; });
  grid.title = "rating";
  grid.note =
      "Bradley-Terry over all matches; 0 is the mean of the teams. Better: likelihood that the "
      "team is better than the next one.";
  grid.words = {0};
  grid.rows = {{"team", "Elo", "+- 95 %", "better", "matches"}};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t team = order[i];
    grid.rows.push_back(
        {report.team(static_cast<int>(team)), fmt::format("{:+.0f}", ratings.elo[team]),
         fmt::format("{:.0f}", ratings.error[team]),
         i + 1 < order.size() ? superiority(ratings.superiority[team][order[i + 1]]) : "",
         fmt::to_string(report.records[team].games())});
  }
  return grid;
}

Grid failures_grid(const Report& report) {
  Grid grid;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome || match.outcome->played()) continue;
    const Outcome& outcome = *match.outcome;
    if (grid.rows.empty()) {
      grid.title = "failed matches";
      grid.words = {1, 2, 3, 4, 5};
      grid.rows = {{"match", "left", "right", "end", "what happened", "logs", "again"}};
      grid.words.push_back(6);
    }
    grid.rows.push_back({fmt::to_string(match.fixture.index), report.team(match.fixture.left),
                         report.team(match.fixture.right), outcome.end_reason, outcome.message,
                         outcome.folder.empty() ? "" : (report.folder / outcome.folder).string(),
                         rerun_line(*report.config, match.fixture)});
  }
  return grid;
}

Grid matches_grid(const Report& report) {
  Grid grid;
  grid.title = "matches";
  grid.words = {1, 2, 3, 6};
  grid.rows = {{"match", "stage", "left", "right", "score", "seed", "host", "cycles/s"}};
  for (const ScheduledMatch& match : report.matches) {
    const Fixture& fixture = match.fixture;
    grid.rows.push_back(
        {fmt::to_string(fixture.index),
         fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage,
         report.team(fixture.left), report.team(fixture.right), score_text(match),
         fmt::to_string(fixture.seed), match.outcome ? match.outcome->host : "",
         match.outcome ? fmt::format("{:.0f}", match.outcome->cycles_per_second) : ""});
  }
  return grid;
}

std::vector<Grid> report_grids(const Report& report) {
  std::vector<Grid> grids;
  for (const RankedTable& table : report.tables) grids.push_back(standings_grid(report, table));
  for (Grid& grid :
       std::vector{crosstable_grid(report), duels_grid(report), ratings_grid(report)}) {
    if (!grid.rows.empty()) grids.push_back(std::move(grid));
  }
  return grids;
}

}  // namespace cls::orchestration::tournament
