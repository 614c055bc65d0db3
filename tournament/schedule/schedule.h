// The schedule: a pure function of configuration and earlier results.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tournament/config/config.h"
#include "tournament/schedule/fixture.h"
#include "tournament/schedule/standings.h"

namespace cls::tournament {

/// The next matches when all of `so_far` have an outcome; empty when the tournament is complete.
/// Round robin, gauntlet and list are complete after the first call; other formats return the
/// matches whose teams are known. Equal arguments give equal matches on every host. `config` must
/// be valid (validate() in config.h).
std::vector<Fixture> next_fixtures(const TournamentConfig& config,
                                   std::span<const ScheduledMatch> so_far);

/// A table of a tournament: of a group, of all teams, or the ranking of a knockout.
struct RankedTable {
  std::string title;  ///< "", "group A", "knock-out"
  std::vector<Standing> standings;
  bool average = false;  ///< its teams have played different numbers of matches
};

/// The tables of the matches so far; the last one ranks the tournament.
std::vector<RankedTable> tables(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far);

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
std::vector<BracketTie> bracket(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far);

/// The seed of a pairing, from 1 to 2^31 - 1 so that every soccer server accepts it. Pairings of a
/// tournament have distinct seeds.
std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing);

}  // namespace cls::tournament
