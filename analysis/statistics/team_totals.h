// Sums over the passes, shots and chains of a team.
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
  int overtaken = 0;
};
PassTotals pass_totals(const MatchStatistics& statistics, std::size_t team);

struct ShotTotals {
  int total = 0;
  int on_target = 0;
  std::array<int, 6> outcomes = {};  ///< by ShotOutcome
  double expected = 0.0;             ///< sum of goal probabilities
  double expected_by_chain = 0.0;    ///< of at least one goal per chain, summed
};
ShotTotals shot_totals(const MatchStatistics& statistics, std::size_t team);

struct ChainTotals {
  int count = 0;
  double mean_passes = 0.0;
  double mean_frames = 0.0;
  int from_set_play = 0;
  std::array<int, 5> results = {};  ///< by ChainResult
};
ChainTotals chain_totals(const MatchStatistics& statistics, std::size_t team);

}  // namespace cls::analysis
