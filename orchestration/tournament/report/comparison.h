// `cls compare`: is NEW better than BASE? Pairs of matches until a sequential test knows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/rating/sprt.h"
#include "orchestration/tournament/rating/statistics.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// What is compared. Team 0 of the configuration is NEW, team 1 BASE, those after them the
/// opponents; without opponents NEW plays BASE.
struct Comparison {
  TournamentConfig config;
  SprtSettings sprt;
  std::optional<int> max_samples;  ///< pairs of matches, or quartets with opponents; none: no end
};

/// The next matches when all before are done: pairs of NEW against BASE on one seed, sides swapped;
/// with opponents quartets on one seed: NEW both sides, then BASE both sides, against one of them
/// after the other. Empty when `max_samples` are scheduled.
std::vector<Fixture> next_fixtures(const Comparison& comparison,
                                   std::span<const ScheduledMatch> so_far);

/// What the matches say. Samples are taken in the order of the schedule up to the first that is
/// not done, so the answer does not depend on which match happens to end first; after the sample
/// that decides nothing counts any more.
struct ComparisonVerdict {
  SprtState state;
  double score0 = 0.5;  ///< expected mean of a sample under H0
  double score1 = 0.5;  ///< and under H1
  Frequencies samples;  ///< counted: five outcomes of pairs, or nine of quartets
  int left_out = 0;     ///< samples with an invalid match
  Estimate strength;    ///< of NEW against BASE; with opponents its score is 1/2 + half the
                        ///< difference of the two scores, and no Elo follows
  std::string model;    ///< one line that names the test
};

ComparisonVerdict verdict(const Comparison& comparison, std::span<const ScheduledMatch> matches);

}  // namespace cls::orchestration::tournament
