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

/// True without opponents: NEW plays BASE.
bool is_direct(const Comparison& comparison);

/// A sample of the test: "pairs" of two matches, or "quartets" of four.
std::string_view sample_name(const Comparison& comparison);
int matches_in_sample(const Comparison& comparison);

/// The difference of two score rates that a quartet's mean `score` says: twice its distance from
/// 1/2.
double gain(double score);

/// The next matches when all before are done: pairs of NEW against BASE on one seed, sides swapped;
/// with opponents quartets on one seed: NEW on both sides, then BASE on both sides, against one
/// opponent. The opponents take turns. Empty when `max_samples` are scheduled.
std::vector<Fixture> next_fixtures(const Comparison& comparison,
                                   std::span<const ScheduledMatch> so_far);

/// Number of the last match that `max_samples` allows; a folder may hold more.
std::optional<int> last_match(const Comparison& comparison);

/// The result of the test. Samples count in schedule order up to the first that is not done, so the
/// decision does not depend on which match ends first. Samples after the decision and above
/// `max_samples` do not count.
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

/// The samples that the test still needs on average, at most `max_samples`: if NEW is as strong as
/// the samples so far say; before these say enough, if H0 or H1 is true.
double expected_samples_left(const Comparison& comparison, const ComparisonVerdict& known);

/// The same before the first match, if the true difference is halfway between H0 and H1, where the
/// test takes longest.
double max_expected_samples(const Comparison& comparison);

/// "better", "not better" or "undecided".
std::string_view verdict_name(const ComparisonVerdict& verdict);

/// A few lines of at most `width` characters: verdict, strength with its interval, samples and
/// test.
std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t width = 80);

/// The document cls.compare/1.
std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches);

}  // namespace cls::orchestration::tournament
