// Wins, goals and points of teams over many matches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

/// The row of one team. Goals exclude shoot-outs; a shoot-out or its coin toss only decides the
/// winner.
struct TeamResults {
  std::string team;
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  std::int64_t goals_for = 0;  ///< 64 bits: corrupt logs may state any score
  std::int64_t goals_against = 0;
  int points = 0;  ///< 3 for a win, 1 for a draw

  std::int64_t goal_difference() const { return goals_for - goals_against; }
};

struct TeamTable {
  std::vector<TeamResults> rows;  ///< by points, goal difference, goals, name
  int not_counted = 0;            ///< incomplete matches, or with a team that never connected
};

TeamTable team_table(const std::vector<MatchSummary>& matches);

}  // namespace cls::analysis
