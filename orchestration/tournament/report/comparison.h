// `cls compare`: is NEW better than BASE? Pairs of matches until a sequential test decides.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/rating/sprt.h"
#include "orchestration/tournament/rating/statistics.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// Team 0 of the configuration is NEW, team 1 BASE, further teams are opponents. Without opponents
/// NEW plays BASE.
struct Comparison {
  TournamentConfig config;
  SprtSettings sprt;
  std::optional<int> max_samples;  ///< pairs of matches, or quartets with opponents; none: no limit
};

/// The next matches when all before are done: pairs of NEW against BASE on one seed, sides swapped;
/// with opponents quartets on one seed: NEW on both sides, then BASE on both sides, against one
/// opponent. The opponents take turns. Empty when `max_samples` are scheduled.
std::vector<Fixture> next_fixtures(const Comparison& comparison,
                                   std::span<const ScheduledMatch> so_far);

/// The result of the test. Samples count in schedule order up to the first that is not done, so the
/// decision does not depend on which match ends first. Samples after the decision do not count.
struct ComparisonVerdict {
  SprtState state;
  double score0 = 0.5;  ///< expected mean of a sample under H0
  double score1 = 0.5;  ///< and under H1
  Frequencies samples;  ///< counts of the five outcomes of pairs, or the nine of quartets
  int left_out = 0;     ///< samples excluded because of an invalid match
  Estimate strength;    ///< of NEW against BASE; with opponents the score is 1/2 + half the
                        ///< difference of the two scores, and Elo does not apply
  std::string model;    ///< one line that names the test
};

ComparisonVerdict verdict(const Comparison& comparison, std::span<const ScheduledMatch> matches);

/// "better", "not better" or "undecided".
std::string_view verdict_name(const ComparisonVerdict& verdict);

/// A few lines: verdict, strength with its interval, samples and test.
std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches);

/// The document cls.compare/1.
std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches);

}  // namespace cls::orchestration::tournament
