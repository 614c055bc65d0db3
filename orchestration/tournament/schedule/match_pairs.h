// Matches of a tournament as results for statistics: games, and pairs on one seed.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "orchestration/tournament/rating/bradley_terry.h"
#include "orchestration/tournament/rating/sprt.h"
#include "orchestration/tournament/rating/statistics.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// All that team `first` did against `second`. Only matches that were really played count:
/// forfeits and invalid ones say nothing about strength.
struct Duel {
  int first = 0;
  int second = 0;
  WinDrawLoss games;
  int goals_for = 0;
  int goals_against = 0;
  Frequencies pairs = Frequencies(5);  ///< complete pairs of `first`, by points 0, 1/2, ... 2
  int single_games = 0;                ///< played games whose partner was not

  /// From the pairs where there are any (single games are left out), else from games.
  Estimate strength() const;
  bool paired() const;
};

/// The duels of all teams that met, first < second.
std::vector<Duel> duels(std::span<const ScheduledMatch> matches);

/// The duel as `second` sees it.
Duel turned(const Duel& duel);

/// A team's results against everybody.
WinDrawLoss record_of(int team, std::span<const Duel> duels);

/// For fit_bradley_terry.
std::vector<PairResults> results_of(std::span<const Duel> duels);

}  // namespace cls::orchestration::tournament
