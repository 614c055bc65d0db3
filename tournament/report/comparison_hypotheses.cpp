// From advantages of a team to means of samples, and the length of the test.
#include "tournament/report/comparison_hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "tournament/report/report_tables.h"

namespace cls::tournament {
namespace {

// The mean of samples where NEW has this advantage.
double mean_at(const Comparison& comparison, double advantage) {
  const double limit = limit_of(comparison, comparison.test.measure);
  const double span = is_direct(comparison) ? 2 * limit : 4 * limit;
  const bool halves = comparison.test.measure == Measure::kPoints && !is_direct(comparison);
  return 0.5 + (halves ? 2 : 1) * advantage / span;
}

std::string sample_text(const Comparison& comparison) {
  return is_direct(comparison)
             ? "pairs on one seed, sides swapped"
             : "pair of NEW minus pair of BASE against the same opponent on one seed";
}

// Scores of the samples so far; before they say enough also some of a team at H0.
struct Assumed {
  double mean;
  double variance;
};

Assumed assumed(const Comparison& comparison, const ComparisonVerdict& known) {
  const double count = total(known.samples);
  const double typical = typical_variance(comparison);
  if (comparison.test.kind == TestKind::kSprt) {
    if (count >= kMinSprtResults) return {mean(known.samples), variance(known.samples)};
    return {known.hypotheses.mean0, typical};
  }
  constexpr double kFew = 2.0;
  const auto weighted = [&](double seen, double prior) {
    return (count * seen + kFew * prior) / (count + kFew);
  };
  return {weighted(mean(known.samples), known.hypotheses.mean0),
          weighted(variance(known.samples), typical)};
}

double samples_left(const Comparison& comparison, const ComparisonVerdict& known,
                    const Assumed& assumed) {
  if (comparison.test.kind == TestKind::kBetting) {
    return known.betting.expected_samples(assumed.mean, assumed.variance);
  }
  const double left = expected_results(known.llr, assumed.mean, assumed.variance, known.hypotheses);
  return std::max(left, kMinSprtResults - total(known.samples));
}

double limited(const Comparison& comparison, double samples, double done) {
  if (!comparison.max_samples) return samples;
  return std::clamp(*comparison.max_samples - done, 0.0, samples);
}

}  // namespace

int limit_of(const Comparison& comparison, Measure measure) {
  return measure == Measure::kPoints ? 1 : comparison.test.max_goals;
}

int steps_of(const Comparison& comparison, Measure measure) {
  return limit_of(comparison, measure) * (measure == Measure::kValue ? kValueSteps : 1);
}

Hypotheses hypotheses_of(const Comparison& comparison) {
  const TestSettings& test = comparison.test;
  const auto mean = [&](double elo, double goals) {
    if (in_goals(test.measure)) return mean_at(comparison, goals);
    return mean_at(comparison, (is_direct(comparison) ? 2 : 1) * (score_from_elo(elo) - 0.5));
  };
  return {mean(test.elo0, test.goals0), mean(test.elo1, test.goals1), test.alpha, test.beta};
}

double typical_variance(const Comparison& comparison) {
  constexpr double kOfPair = 0.15;
  constexpr double kOfGoals = 0.5;
  constexpr double kOfValue = 2.0;
  const double limit = comparison.test.max_goals;
  const double of_square = comparison.test.measure == Measure::kValue ? kOfValue : kOfGoals;
  const double of_pair = comparison.test.measure == Measure::kPoints
                             ? kOfPair
                             : std::min(kOfPair, of_square / (limit * limit));
  return is_direct(comparison) ? of_pair : of_pair / 2;
}

std::string model_text(const Comparison& comparison) {
  const TestSettings& test = comparison.test;
  const std::string errors = fmt::format("alpha {:g}, beta {:g}", test.alpha, test.beta);
  const std::string_view name = test.kind == TestKind::kBetting ? "betting test"
                                : in_goals(test.measure)        ? "multinomial SPRT"
                                : is_direct(comparison)         ? "pentanomial SPRT"
                                                                : "nonanomial SPRT";

  const std::string start = fmt::format("{} ({})", name, sample_text(comparison));
  if (in_goals(test.measure)) {
    const bool goals = test.measure == Measure::kGoals;
    return fmt::format("{}, {} up to {}: H0 {:+g} goals a match, H1 {:+g}, {}", start,
                       goals ? "goal difference" : "value of situations", test.max_goals,
                       test.goals0, test.goals1, errors);
  }

  if (is_direct(comparison)) {
    return fmt::format("{}, logistic Elo: H0 {:+g}, H1 {:+g}, {}", start, test.elo0, test.elo1,
                       errors);
  }
  return fmt::format(
      "{}: H0 a gain of {:+.1f} % of the points (Elo {:+g} between equals), H1 {:+.1f} % ({:+g}), "
      "{}",
      start, 100 * (score_from_elo(test.elo0) - 0.5), test.elo0,
      100 * (score_from_elo(test.elo1) - 0.5), test.elo1, errors);
}

std::string test_error(const TestSettings& test) {
  if (test.measure == Measure::kPoints && test.elo0 >= test.elo1) {
    return "--elo0 must be below --elo1";
  }
  if (in_goals(test.measure)) {
    if (test.goals0 >= test.goals1) return "--goals0 must be below --goals1";
    if (test.goals1 >= test.max_goals || test.goals0 <= -test.max_goals) {
      return "--goals0 and --goals1 must be within --max-goals";
    }
  }
  const auto is_rate = [](double rate) { return rate > 0 && rate < 0.5; };
  if (!is_rate(test.alpha) || !is_rate(test.beta)) {
    return "--alpha and --beta must be between 0 and 0.5";
  }
  return {};
}

double advantage(const Comparison& comparison, double mean) {
  return (mean - 0.5) / (mean_at(comparison, 1.0) - 0.5);
}

std::string advantage_text(const Comparison& comparison, double mean) {
  if (in_goals(comparison.test.measure)) {
    return difference_text(advantage(comparison, mean), 2) + " goals a match";
  }
  if (is_direct(comparison)) return difference_text(elo_from_score(mean), 1) + " Elo";
  return difference_text(100 * advantage(comparison, mean), 1) + " % of the points";
}

double expected_samples_left(const Comparison& comparison, const ComparisonVerdict& known) {
  if (known.decision != Decision::kOpen) return 0.0;
  return limited(comparison, samples_left(comparison, known, assumed(comparison, known)),
                 total(known.samples) + known.left_out);
}

double max_expected_samples(const Comparison& comparison) {
  const ComparisonVerdict start = verdict(comparison, {});
  const double halfway = (start.hypotheses.mean0 + start.hypotheses.mean1) / 2;
  return limited(comparison,
                 samples_left(comparison, start, {halfway, typical_variance(comparison)}), 0.0);
}

}  // namespace cls::tournament
