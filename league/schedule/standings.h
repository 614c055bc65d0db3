// Standings: points, goals, and the order of teams with the same points.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "league/competition/competition.h"
#include "league/matches/fixture.h"
#include "league/matches/head_to_head.h"

namespace cls::league {

/// A row of a table. Goals of a shoot-out do not count; its winner has won the match.
struct Standing {
  int team = 0;
  int rank = 1;  ///< shared by teams that no criterion separates
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  int invalid = 0;     ///< matches of this team without a result
  WinLoss shoot_outs;  ///< part of won and lost
  WinLoss forfeits;    ///< part of won and lost
  int goals_for = 0;
  int goals_against = 0;
  int byes = 0;
  int points = 0;                 ///< 3 for a win, 1 for a draw; a bye counts as wins
  double buchholz = 0.0;          ///< sum of the opponents' points
  double median_buchholz = 0.0;   ///< without the highest and the lowest
  double sonneborn_berger = 0.0;  ///< points of beaten opponents, half of those drawn with
  TeamRecord record;              ///< over the matches of this table
  std::string separated_by;       ///< the tiebreaker that ranked it below the team above, or empty

  int goal_difference() const { return goals_for - goals_against; }
};

/// A bye of a Swiss tournament.
struct Bye {
  int team = 0;
  int matches = 0;  ///< won by the bye
  int round = 1;
};

/// The table of `teams` over those `matches` whose two teams belong to it.
///
/// Order: points per match, then the tiebreakers. After each one that separates teams, those still
/// tied start again at the first. Head-to-head counts points in matches between the tied teams: of
/// two teams the one with more points is first, of more a team that has beaten all others. Teams
/// that no tiebreaker separates share a rank, in the order of `teams`.
std::vector<Standing> standings(std::span<const int> teams, std::span<const ScheduledMatch> matches,
                                const std::vector<TieBreaker>& breakers,
                                std::span<const Bye> byes = {});

/// The names of the criteria in Standing::separated_by of draw_lots().
inline constexpr const char* kLot = "lot";
inline constexpr const char* kDecision = "decision";

/// Gives teams that share a rank of the first `places` ranks of their own, in the order that was
/// decided for the table of this title, else in one drawn from `seed`: for tables whose order
/// decides who goes on. Each table has its own lots.
void draw_lots(std::uint64_t seed, std::string_view title, int places,
               std::span<const MatchDecision> orders, std::vector<Standing>& table);

}  // namespace cls::league
