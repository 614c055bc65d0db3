// Head-to-head records of teams for statistics: games, and pairs of games on one seed.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "orchestration/tournament/rating/bradley_terry.h"
#include "orchestration/tournament/rating/sprt.h"
#include "orchestration/tournament/rating/statistics.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// Results of team `first` against `second`. Forfeits and invalid matches do not count.
struct HeadToHead {
  int first = 0;
  int second = 0;
  WinDrawLoss games;
  int goals_for = 0;
  int goals_against = 0;
  Frequencies pairs = Frequencies(5);  ///< complete pairs of `first`, by points 0, 1/2, ... 2
  int single_games = 0;                ///< played games whose other game was not played

  /// From the pairs if there are any (excluding single games), otherwise from the games.
  Estimate strength() const;
  bool paired() const;
};

/// The records of all teams that met, first < second.
std::vector<HeadToHead> head_to_heads(std::span<const ScheduledMatch> matches);

/// The record of `second` against `first`.
HeadToHead reversed(const HeadToHead& head_to_head);

/// A team's results against all opponents.
WinDrawLoss record_of(int team, std::span<const HeadToHead> head_to_heads);

/// For fit_bradley_terry.
std::vector<PairResults> results_of(std::span<const HeadToHead> head_to_heads);

}  // namespace cls::orchestration::tournament
