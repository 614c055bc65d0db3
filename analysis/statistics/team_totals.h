// Sums over the players and events of a team.
#pragma once

#include <array>
#include <cstddef>

#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

struct PassTotals {
  int attempted = 0;
  int completed = 0;
  std::array<int, 6> outcomes = {};    ///< by PassOutcome
  std::array<int, 4> directions = {};  ///< of completed passes, by PassDirection
  double mean_length = 0.0;            ///< of completed passes
  int through = 0;
  int crosses = 0;
  int switches = 0;
  int cutbacks = 0;
  int clearances = 0;
  int one_twos = 0;
  int overtaken = 0;
};

struct ShotTotals {
  int total = 0;
  int on_target = 0;
  std::array<int, 6> outcomes = {};  ///< by ShotOutcome
  double expected = 0.0;             ///< sum of goal probabilities
  double expected_by_chain = 0.0;    ///< of at least one goal per chain, summed
};

struct ChainTotals {
  int count = 0;
  double mean_passes = 0.0;
  double mean_frames = 0.0;
  int from_set_play = 0;
  std::array<int, 5> results = {};  ///< by ChainResult
};

struct TeamTotals {
  int touches = 0;
  PassTotals passes;
  ChainTotals chains;
  ShotTotals shots;
  int carries = 0;
  int dribbles = 0;
  int take_ons = 0;
  int goals = 0;
  int own_goals = 0;
  double threat = 0.0;
  Tackles tackles;
  int interceptions = 0;
  double distance = 0.0;
  double stamina_used = 0.0;
  int exhausted_frames = 0;
  int steps = 0;  ///< only with a text log, as the next two
  int silent = 0;
  int rejected = 0;
};

TeamTotals sum_team(const MatchStatistics& statistics, std::size_t team);

}  // namespace cls::analysis
