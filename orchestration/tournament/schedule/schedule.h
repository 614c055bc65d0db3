// Who plays whom, when and on which seed: a pure function of configuration and earlier results.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"
#include "orchestration/tournament/schedule/standings.h"

namespace cls::orchestration::tournament {

/// The matches that can be scheduled next when all of `so_far` have their outcome; empty when the
/// tournament is over. Round robin, gauntlet and list come whole at the first call; the other
/// formats as far as results decide who meets whom. The same arguments give the same matches, on
/// every machine. `config` must be without mistakes (config.h).
std::vector<Fixture> next_fixtures(const TournamentConfig& config,
                                   std::span<const ScheduledMatch> so_far);

/// Part of the final word of a tournament: the table of a group, of everybody, or of the places
/// that a knock-out gave.
struct RankedTable {
  std::string title;  ///< "", "group A", "knock-out"
  std::vector<Standing> standings;
};

/// The tables over what was played so far; the last one ranks the tournament.
std::vector<RankedTable> tables(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far);

/// The seed of a pairing, from 1 to 2^31 - 1 so that every soccer server takes it. Different
/// pairings of a tournament have different seeds.
std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing);

}  // namespace cls::orchestration::tournament
