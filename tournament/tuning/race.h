// One generation: candidates play the same seeds against the same opponents; those that are worse
// than the others beyond doubt stop early.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "league/matches/fixture.h"
#include "tournament/tuning/tune_config.h"

namespace cls::tournament {

/// Teams 0 to candidates - 1 are candidates, the rest opponents. Without opponents the two
/// candidates play each other.
struct Race {
  int generation = 1;
  int candidates = 0;
  int opponents = 0;
};

/// The result of a candidate.
struct RaceResult {
  std::vector<double> pairs;  ///< value of each pair played, from 0 to 1; 1/2 is an even result
  bool stopped = false;       ///< early

  double mean() const;
};

/// The results so far; matches that are not done are ignored.
std::vector<RaceResult> race_results(const TuneConfig& config, const Race& race,
                                     std::span<const ScheduledMatch> matches);

/// The next round when all before are done: one pair of matches for each candidate that still
/// plays, all on one seed. Empty when the race is over. A pure function.
std::vector<Fixture> next_round(const TuneConfig& config, const Race& race,
                                std::span<const ScheduledMatch> so_far);

/// Results as an optimizer needs them: a stopped candidate is below all others, the earlier it
/// stopped the more.
std::vector<double> ranking_values(const TuneConfig& config,
                                   const std::vector<RaceResult>& results);

}  // namespace cls::tournament
