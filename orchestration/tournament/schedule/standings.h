// Tables: points, goals, and the order of teams with the same points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// A line of a table. Goals of shoot-outs are not counted; their winner has won the match.
struct Standing {
  int team = 0;
  int rank = 1;  ///< teams that nothing separates share one
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  int invalid = 0;  ///< matches of this team without a result
  int goals_for = 0;
  int goals_against = 0;
  int byes = 0;
  int points = 0;         ///< 3 for a win, 1 for a draw; a bye counts like the wins it stands for
  double buchholz = 0.0;  ///< sum of the opponents' points
  double median_buchholz = 0.0;   ///< without the highest and the lowest
  double sonneborn_berger = 0.0;  ///< points of beaten opponents, half of those drawn with
  std::string separated_by;       ///< the criterion that put it behind the team above, or empty

  int goal_difference() const { return goals_for - goals_against; }
};

/// A free round of a Swiss tournament.
struct Bye {
  int team = 0;
  int matches = 0;  ///< that it stands for
};

/// The criteria of a format when the configuration names none. Round robin and groups follow the
/// order of the league (match-statistics 10), without its deciding shoot-out.
std::vector<TieBreaker> tie_breakers_of(const TournamentConfig& config);

/// The table of `teams` over those of `matches` that both sides belong to.
///
/// Order: points per match, then the criteria; after each one that separates, what is still level
/// starts again at the first criterion. Head-to-head looks at the points of the matches between the
/// tied: of two the one with more; of more than two one that has beaten all others. What nothing
/// separates shares a rank and stands in the order of `teams`.
std::vector<Standing> standings(std::span<const int> teams, std::span<const ScheduledMatch> matches,
                                const std::vector<TieBreaker>& breakers,
                                std::span<const Bye> byes = {});

}  // namespace cls::orchestration::tournament
