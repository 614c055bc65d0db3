// Competitions of made-up teams, and made-up results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "league/competition/competition.h"
#include "league/matches/fixture.h"

namespace cls::league {

/// Teams A, B, C, ... on mocks.
Competition competition_of(Format format, int teams);

/// The outcome of a finished match.
Outcome score(int left, int right);

/// The outcome of a match that ended for `reason` by the left side's fault.
Outcome fault(soccer::EndReason reason);

/// Decides the outcome of a fixture.
using Referee = std::function<Outcome(const Fixture&)>;

/// The team with the lower index wins 1:0.
Outcome better_wins(const Fixture& fixture);

/// Results that depend on the fixture only, with draws where they are possible.
Referee random_results(std::uint64_t seed);

/// Plays until the competition is complete.
std::vector<ScheduledMatch> play_all(const Competition& competition, const Referee& referee);

/// "A-B" for each fixture.
std::vector<std::string> pairs_of(const std::vector<Fixture>& fixtures);
std::vector<std::string> pairs_of(const std::vector<ScheduledMatch>& matches);

/// Names of the teams in the last table, by rank.
std::vector<std::string> ranking(const Competition& competition,
                                 const std::vector<ScheduledMatch>& matches);

}  // namespace cls::league
