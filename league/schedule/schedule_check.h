// Checks that matches read from a folder are those of its plan: folders are copied, edited and cut.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/result.h"
#include "league/competition/competition.h"
#include "league/matches/fixture.h"

namespace cls::league {

/// An error unless both sides are teams of `competition`. It names the match.
base::Result<void> check_teams(const Competition& competition, const Fixture& fixture);

/// An error unless the matches have the numbers 1, 2, 3, ... and teams of `competition`. Callers
/// may then use numbers and teams as indices.
base::Result<void> check_rows(const Competition& competition,
                              std::span<const ScheduledMatch> matches);

/// The first round that is not as next_fixtures() schedules it.
struct Contradiction {
  int first = 0;        ///< number of the first match of this round
  std::string problem;  ///< names the match
};
std::optional<Contradiction> find_contradiction(const Competition& competition,
                                                std::span<const ScheduledMatch> matches);

/// An error unless the matches, which passed check_rows(), are those that next_fixtures()
/// schedules. It names the first match that is missing or different.
base::Result<void> check_schedule(const Competition& competition,
                                  std::span<const ScheduledMatch> matches);

}  // namespace cls::league
