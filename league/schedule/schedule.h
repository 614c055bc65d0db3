// The schedule: a pure function of a competition and earlier results.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "league/competition/competition.h"
#include "league/matches/fixture.h"
#include "league/schedule/formats.h"

namespace cls::league {

/// The next matches when all of `so_far` have an outcome; empty when the competition is complete.
/// Round robin, gauntlet and list are complete after the first call; other formats return the
/// matches whose teams are known. Equal arguments give equal matches on every host. `competition`
/// must be valid (competition_errors()).
std::vector<Fixture> next_fixtures(const Competition& competition,
                                   std::span<const ScheduledMatch> so_far);

/// The tables of the matches so far; the last one ranks the competition.
std::vector<RankedTable> tables(const Competition& competition,
                                std::span<const ScheduledMatch> so_far);

/// Teams that are equal in every tiebreaker of a table whose order decides who goes on: a lot or a
/// decision has given them their order.
struct EqualTeams {
  std::string table;       ///< title
  std::vector<int> teams;  ///< best first
  bool decided = false;    ///< by a decision, else by a lot
};

std::vector<EqualTeams> equal_teams(const Competition& competition,
                                    std::span<const ScheduledMatch> so_far);

/// The byes of a Swiss tournament.
std::vector<Bye> byes(const Competition& competition, std::span<const ScheduledMatch> so_far);

/// A place in a knockout bracket: a team, nothing while it is not known, or a bye.
struct Entrant {
  std::optional<int> team;
  bool bye = false;
  int tie = -1;        ///< position in bracket() of the tie it comes from; -1: it starts here
  bool winner = true;  ///< of that tie, else its loser
};

/// A tie of a bracket: one or more matches between two entrants; with a bye none.
struct BracketTie {
  int round = 1;
  std::string stage;  ///< as in Fixture::stage
  std::array<Entrant, 2> entrants;
  std::optional<int> winner;  ///< a team
  bool by_lot = false;        ///< drawn, because no match decided it
};

/// The ties of a knockout, from the first round to the last, known entrants and unknown ones. Empty
/// for formats without a bracket, and while groups are being played.
std::vector<BracketTie> bracket(const Competition& competition,
                                std::span<const ScheduledMatch> so_far);

}  // namespace cls::league
