// `cls compare`: is NEW better than BASE? Pairs of matches until a sequential test decides.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "league/matches/fixture.h"
#include "league/rating/betting.h"
#include "league/rating/hypotheses.h"
#include "league/rating/sprt.h"
#include "league/rating/statistics.h"
#include "tournament/config/config.h"

namespace cls::tournament {

enum class TestKind { kBetting, kSprt };
/// kValue: the value of a book's situations, in goals a match.
enum class Measure { kPoints, kGoals, kValue };

/// True where the unit is goals a match.
inline bool in_goals(Measure measure) { return measure != Measure::kPoints; }
inline constexpr auto kMeasures = base::enum_names<Measure>("points", "goals", "value");
constexpr std::string_view name(Measure measure) { return kMeasures.name(measure); }

/// The steps of a goal to which values are rounded.
inline constexpr int kValueSteps = 20;
/// A value above it counts as this, where no other limit is given: situations vary more than whole
/// matches.
inline constexpr int kMaxValue = 8;

/// H0: NEW is better than BASE by `elo0` at most, or by `goals0` goals a match; H1: by `elo1` at
/// least, or by `goals1`. Errors as in Hypotheses.
struct TestSettings {
  TestKind kind = TestKind::kBetting;
  Measure measure = Measure::kPoints;
  double elo0 = league::kUsualElo0;
  double elo1 = league::kUsualElo1;
  double goals0 = 0.0;
  double goals1 = 0.5;
  int max_goals = 3;  ///< a goal difference above it counts as this
  double alpha = 0.05;
  double beta = 0.05;
};

/// Team 0 of the configuration is NEW, team 1 BASE, further teams are opponents. Without opponents
/// NEW plays BASE.
struct Comparison {
  TournamentConfig config;
  TestSettings test;
  std::optional<int> max_samples;  ///< pairs of matches, or quartets with opponents; none: no limit
};

/// The measure of the left team in a match that was played, in steps: points and goals as whole
/// numbers, values in 1 / kValueSteps; at most `limit`.
int counted_value(const Outcome& outcome, Measure measure, int limit);

/// True without opponents: NEW plays BASE.
bool is_direct(const Comparison& comparison);

/// A sample of the test: "pairs" of two matches, or "quartets" of four.
std::string_view sample_name(const Comparison& comparison);
int matches_in_sample(const Comparison& comparison);

/// The error of the settings, with the names of options; empty: there is none.
std::string test_error(const TestSettings& test);

/// A sample is the sum of the measure over its matches, scaled to 0 to 1: 1/2 means that NEW and
/// BASE are equal. This is the advantage of NEW that a mean of samples shows: with points the
/// difference of two score rates (directly: twice the distance of the score from 1/2), with goals
/// goals a match.
double advantage(const Comparison& comparison, double mean);

/// The difference of two score rates that a mean score in points shows.
inline double gain(double score) { return 2 * (score - 0.5); }

/// The advantage in words: "+12.3 Elo", against opponents "+1.2 % of the points", "+0.25 goals a
/// match".
std::string advantage_text(const Comparison& comparison, double mean);

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
  Decision decision = Decision::kOpen;
  Hypotheses hypotheses;  ///< on the mean of the samples
  BettingTest betting;    ///< with the other test too, which then does not decide
  double llr = 0.0;       ///< of the SPRT, with the other test too
  Frequencies samples;    ///< counts of the outcomes: of points the five of pairs or the nine of
                          ///< quartets
  Frequencies points;     ///< the same for points, whatever the measure
  int left_out = 0;       ///< samples excluded because of an invalid match
  Estimate strength;      ///< of NEW against BASE by points; with opponents the score is 1/2 + half
                          ///< the difference of the two scores, and Elo does not apply
  std::string model;      ///< one line that names the test
};

ComparisonVerdict verdict(const Comparison& comparison, std::span<const ScheduledMatch> matches);

/// The samples that the test still needs on average, at most `max_samples`: if NEW is as strong as
/// the samples so far say; before these say enough, if H0 or H1 is true.
double expected_samples_left(const Comparison& comparison, const ComparisonVerdict& known);

/// The number of samples expected before the first match if the true difference is halfway between
/// H0 and H1, where the test takes longest.
double max_expected_samples(const Comparison& comparison);

/// The samples until the verdict if NEW gets the most out of every match.
int walkover_samples(const Comparison& comparison);

/// "better", "not better" or "undecided".
std::string_view verdict_name(const ComparisonVerdict& verdict);

/// A few lines of at most `width` characters: verdict, strength with its interval, samples and
/// test.
std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t width = 80);

/// The document cls.compare/1. `alike`: samples in which NEW and BASE sent the same commands.
std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t alike = 0);

}  // namespace cls::tournament
