// Collects the samples of the test from matches.
#include "tournament/report/comparison.h"

#include <algorithm>
#include <cmath>

#include "league/schedule/schedule.h"
#include "tournament/report/comparison_hypotheses.h"

namespace cls::tournament {
namespace {

constexpr int kNew = 0;
constexpr int kBase = 1;
constexpr int kSamplesPerBatch = 50;

int opponents_of(const Comparison& comparison) {
  return comparison.config.competition.team_count() - 2;
}

void add_pair(const Comparison& comparison, std::vector<Fixture>& fixtures, int index, int sample,
              int pairing, int first, int second) {
  for (const bool swapped : {false, true}) {
    // All matches of a sample have one seed, so that they differ in the teams alone.
    fixtures.push_back({.index = index++,
                        .round = sample,
                        .stage = "",
                        .pairing = pairing,
                        .left = swapped ? second : first,
                        .right = swapped ? first : second,
                        .seed = pairing_seed(comparison.config.competition.seed, sample)});
  }
}

// The measure of `team` in the matches of one sample.
int sum_of(std::span<const ScheduledMatch> sample, int team, Measure measure, int limit) {
  int sum = 0;
  for (const ScheduledMatch& match : sample) {
    const int counted = counted_value(*match.outcome, measure, limit);
    if (match.fixture.left == team) sum += counted;
    if (match.fixture.right == team) sum -= counted;
  }
  return sum;
}

std::size_t outcomes_of(const Comparison& comparison, Measure measure) {
  const int span = 2 * matches_in_sample(comparison) * steps_of(comparison, measure);
  return base::index(span + 1);
}

// From worst to best; the middle one means that NEW and BASE are equal.
std::size_t outcome_of(const Comparison& comparison, std::span<const ScheduledMatch> sample,
                       Measure measure) {
  const int limit = steps_of(comparison, measure);
  int sum = sum_of(sample, kNew, measure, limit);
  if (!is_direct(comparison)) sum -= sum_of(sample, kBase, measure, limit);
  return base::index(sum + matches_in_sample(comparison) * limit);
}

void add_sample(ComparisonVerdict& verdict, std::size_t outcome, TestKind kind) {
  verdict.samples[outcome] += 1;
  verdict.betting.add(static_cast<double>(outcome) /
                      static_cast<double>(verdict.samples.size() - 1));
  verdict.decision = kind == TestKind::kBetting
                         ? verdict.betting.decision()
                         : sprt_state(verdict.samples, verdict.hypotheses).decision;
}

}  // namespace

int counted_value(const Outcome& outcome, Measure measure, int limit) {
  int value = outcome.left_score - outcome.right_score;
  if (measure == Measure::kPoints) value = winner_sign(outcome);
  if (measure == Measure::kValue) {
    const double steps = outcome.value.value_or(0.0) * kValueSteps;
    value = static_cast<int>(std::lround(std::clamp<double>(steps, -limit, limit)));
  }
  return std::clamp(value, -limit, limit);
}

bool is_direct(const Comparison& comparison) { return opponents_of(comparison) == 0; }

std::string_view sample_name(const Comparison& comparison) {
  return is_direct(comparison) ? "pairs" : "quartets";
}

int matches_in_sample(const Comparison& comparison) { return is_direct(comparison) ? 2 : 4; }

std::vector<Fixture> next_fixtures(const Comparison& comparison,
                                   std::span<const ScheduledMatch> so_far) {
  const int size = matches_in_sample(comparison);
  const int opponents = opponents_of(comparison);
  const int done = static_cast<int>(so_far.size()) / size;
  const int last =
      std::min(done + kSamplesPerBatch, comparison.max_samples.value_or(done + kSamplesPerBatch));

  std::vector<Fixture> fixtures;
  for (int sample = done + 1; sample <= last; ++sample) {
    const int index = (sample - 1) * size + 1;
    if (opponents == 0) {
      add_pair(comparison, fixtures, index, sample, sample, kNew, kBase);
      continue;
    }
    const int opponent = 2 + (sample - 1) % opponents;
    add_pair(comparison, fixtures, index, sample, 2 * sample - 1, kNew, opponent);
    add_pair(comparison, fixtures, index + 2, sample, 2 * sample, kBase, opponent);
  }
  return fixtures;
}

std::optional<int> last_match(const Comparison& comparison) {
  if (!comparison.max_samples) return std::nullopt;
  return *comparison.max_samples * matches_in_sample(comparison);
}

ComparisonVerdict verdict(const Comparison& comparison, std::span<const ScheduledMatch> matches) {
  if (const auto last = last_match(comparison)) {
    matches = matches.first(std::min(matches.size(), base::index(*last)));
  }

  ComparisonVerdict verdict;
  const Measure measure = comparison.test.measure;
  verdict.hypotheses = hypotheses_of(comparison);
  verdict.betting = BettingTest(verdict.hypotheses, typical_variance(comparison));
  verdict.samples.assign(outcomes_of(comparison, measure), 0.0);
  verdict.points.assign(outcomes_of(comparison, Measure::kPoints), 0.0);
  verdict.model = model_text(comparison);

  const std::size_t size = base::index(matches_in_sample(comparison));
  for (std::size_t at = 0; at + size <= matches.size(); at += size) {
    const auto sample = matches.subspan(at, size);
    if (!all_have_outcomes(sample) || verdict.decision != Decision::kOpen) break;
    const bool played = std::ranges::all_of(
        sample, [](const ScheduledMatch& match) { return match.outcome->played(); });
    if (!played) {
      ++verdict.left_out;
      continue;
    }
    verdict.points[outcome_of(comparison, sample, Measure::kPoints)] += 1;
    add_sample(verdict, outcome_of(comparison, sample, measure), comparison.test.kind);
  }

  verdict.llr = sprt_state(verdict.samples, verdict.hypotheses).llr;
  verdict.strength = estimate(verdict.points);
  return verdict;
}

int walkover_samples(const Comparison& comparison) {
  constexpr int kMaxSamples = 10'000;  // bounds beyond the reach of any team
  ComparisonVerdict verdict = cls::tournament::verdict(comparison, {});
  int count = 0;
  for (; verdict.decision == Decision::kOpen && count < kMaxSamples; ++count) {
    add_sample(verdict, verdict.samples.size() - 1, comparison.test.kind);
  }
  return count;
}

}  // namespace cls::tournament
