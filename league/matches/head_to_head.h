// Records of teams for statistics: games, and pairs of games on one seed.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "league/matches/fixture.h"
#include "league/rating/bradley_terry.h"
#include "league/rating/sprt.h"
#include "league/rating/statistics.h"

namespace cls::league {

/// Won and lost without a draw.
struct WinLoss {
  int won = 0;
  int lost = 0;

  bool any() const { return won + lost > 0; }
};

/// Results of a team. Forfeits and invalid matches do not count in `games` and `pairs`.
struct TeamRecord {
  WinDrawLoss games;
  Frequencies pairs = Frequencies(5);  ///< complete pairs, by points 0, 1/2, ... 2
  int single_games = 0;                ///< played games whose other game was not played

  /// The one estimate of a team's strength, in tables, reports and verdicts: from the pairs if
  /// there are any (excluding single games), otherwise from the games.
  Estimate strength() const;
  bool paired() const;
};

/// Results of team `first` against `second`.
struct HeadToHead : TeamRecord {
  int first = 0;
  int second = 0;
  int goals_for = 0;
  int goals_against = 0;
  WinLoss shoot_outs;  ///< games that a shoot-out decided; part of `games`
  WinLoss forfeits;    ///< not part of `games`
};

/// The records of all teams that met or had a match forfeited, first < second.
std::vector<HeadToHead> head_to_heads(std::span<const ScheduledMatch> matches);

/// The record of `second` against `first`.
HeadToHead reversed(const HeadToHead& head_to_head);

/// A team's results against all opponents.
TeamRecord record_of(int team, std::span<const HeadToHead> head_to_heads);

/// For fit_bradley_terry.
std::vector<PairResults> results_of(std::span<const HeadToHead> head_to_heads);

}  // namespace cls::league
