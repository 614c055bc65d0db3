// The schedule: a pure function of configuration and earlier results.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"
#include "orchestration/tournament/schedule/standings.h"

namespace cls::orchestration::tournament {

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
};

/// The tables of the matches so far; the last one ranks the tournament.
std::vector<RankedTable> tables(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far);

/// The seed of a pairing, from 1 to 2^31 - 1 so that every soccer server accepts it. Pairings of a
/// tournament have distinct seeds.
std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing);

}  // namespace cls::orchestration::tournament
