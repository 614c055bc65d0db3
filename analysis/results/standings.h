// Wins, goals and points of teams over many matches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

/// One team's row. Goals are those of the game; a shoot-out (or its coin toss) only decides who
/// has won.
struct Standing {
  std::string team;
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  std::int64_t goals_for = 0;  ///< of any number of logs, damaged ones too
  std::int64_t goals_against = 0;
  int points = 0;  ///< three for a win, one for a draw

  std::int64_t goal_difference() const { return goals_for - goals_against; }
};

struct Standings {
  std::vector<Standing> rows;  ///< by points, goal difference, goals, name
  int not_counted = 0;         ///< matches without an end, or with a team that never came
};

Standings standings_of(const std::vector<MatchSummary>& matches);

}  // namespace cls::analysis
