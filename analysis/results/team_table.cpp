// Sums results per team.
#include "analysis/results/team_table.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace cls::analysis {
namespace {

constexpr int kPointsForWin = 3;

void add(const TeamSummary& own, const TeamSummary& other, bool won, bool drawn, TeamResults& row) {
  row.team = own.name;
  ++row.played;
  row.won += won;
  row.drawn += drawn;
  row.lost += !won && !drawn;
  row.goals_for += own.score;
  row.goals_against += other.score;
  row.points += won ? kPointsForWin : drawn ? 1 : 0;
}

auto order(const TeamResults& row) {
  return std::make_tuple(-row.points, -row.goal_difference(), -row.goals_for, row.team);
}

}  // namespace

TeamTable team_table(const std::vector<MatchSummary>& matches) {
  TeamTable standings;
  std::map<std::string, TeamResults> by_name;
  for (const MatchSummary& match : matches) {
    const auto& [left, right] = match.teams;
    if (match.winner == Winner::kNone || left.name.empty() || right.name.empty()) {
      ++standings.not_counted;
      continue;
    }

    const bool drawn = match.winner == Winner::kDraw;
    add(left, right, match.winner == Winner::kLeft, drawn, by_name[left.name]);
    add(right, left, match.winner == Winner::kRight, drawn, by_name[right.name]);
  }

  for (auto& [name, row] : by_name) standings.rows.push_back(std::move(row));
  std::ranges::sort(standings.rows, {}, order);
  return standings;
}

}  // namespace cls::analysis
