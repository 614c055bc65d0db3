// Collects the samples of the test from matches.
#include "orchestration/tournament/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "orchestration/tournament/schedule/schedule.h"

namespace cls::orchestration::tournament {
namespace {

constexpr int kNew = 0;
constexpr int kBase = 1;
constexpr int kSamplesPerBatch = 50;

int opponents_of(const Comparison& comparison) {
  return static_cast<int>(comparison.config.teams.size()) - 2;
}

int matches_in_sample(const Comparison& comparison) { return opponents_of(comparison) > 0 ? 4 : 2; }

void add_pair(const Comparison& comparison, std::vector<Fixture>& fixtures, int index, int sample,
              int pairing, int first, int second) {
  for (const bool swapped : {false, true}) {
    Fixture fixture;
    fixture.index = index++;
    fixture.round = sample;
    fixture.pairing = pairing;
    fixture.left = swapped ? second : first;
    fixture.right = swapped ? first : second;
    // All matches of a sample have one seed, so that they differ in the teams alone.
    fixture.seed = pairing_seed(comparison.config.seed, sample);
    fixtures.push_back(std::move(fixture));
  }
}

// Half points of `team` in the matches of one sample, or nothing when one of them was not played.
std::optional<int> half_points(std::span<const ScheduledMatch> sample, int team) {
  int sum = 0;
  for (const ScheduledMatch& match : sample) {
    if (!match.outcome->played()) return std::nullopt;
    const int sign = winner_sign(*match.outcome);
    if (match.fixture.left == team) sum += 1 + sign;
    if (match.fixture.right == team) sum += 1 - sign;
  }
  return sum;
}

// 0..4 of a pair; 0..8 of a quartet, where 4 means equal points for NEW and BASE.
std::optional<std::size_t> outcome_of(const Comparison& comparison,
                                      std::span<const ScheduledMatch> sample) {
  const auto points = half_points(sample, kNew);
  if (!points) return std::nullopt;
  if (opponents_of(comparison) == 0) return static_cast<std::size_t>(*points);
  return static_cast<std::size_t>(4 + *points - *half_points(sample, kBase));
}

void set_model(ComparisonVerdict& verdict, const Comparison& comparison) {
  const SprtSettings& sprt = comparison.sprt;
  const double gain0 = score_from_elo(sprt.elo0) - 0.5;
  const double gain1 = score_from_elo(sprt.elo1) - 0.5;
  if (opponents_of(comparison) == 0) {
    verdict.score0 = 0.5 + gain0;
    verdict.score1 = 0.5 + gain1;
    verdict.samples.assign(5, 0.0);
    verdict.model = fmt::format(
        "pentanomial SPRT (pairs on one seed, sides swapped), logistic Elo: H0 {:+g}, H1 {:+g}, "
        "alpha {:g}, beta {:g}",
        sprt.elo0, sprt.elo1, sprt.alpha, sprt.beta);
    return;
  }
  // A sample's value is 1/2 + (score of NEW - score of BASE) / 2.
  verdict.score0 = 0.5 + gain0 / 2;
  verdict.score1 = 0.5 + gain1 / 2;
  verdict.samples.assign(9, 0.0);
  verdict.model = fmt::format(
      "nonanomial SPRT (pair of NEW minus pair of BASE against the same opponent on one seed): H0 "
      "a gain of {:+.1f} % of the points (Elo {:+g} between equals), H1 {:+.1f} % ({:+g}), alpha "
      "{:g}, beta {:g}",
      100 * gain0, sprt.elo0, 100 * gain1, sprt.elo1, sprt.alpha, sprt.beta);
}

}  // namespace

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

ComparisonVerdict verdict(const Comparison& comparison, std::span<const ScheduledMatch> matches) {
  ComparisonVerdict verdict;
  set_model(verdict, comparison);
  const auto size = static_cast<std::size_t>(matches_in_sample(comparison));
  for (std::size_t at = 0; at + size <= matches.size(); at += size) {
    const auto sample = matches.subspan(at, size);
    const bool done = std::all_of(sample.begin(), sample.end(), [](const ScheduledMatch& match) {
      return match.outcome.has_value();
    });
    if (!done || verdict.state.decision != SprtDecision::kOpen) break;
    const auto outcome = outcome_of(comparison, sample);
    if (!outcome) {
      ++verdict.left_out;
      continue;
    }
    verdict.samples[*outcome] += 1;
    verdict.state = sprt_state(verdict.samples, verdict.score0, verdict.score1, comparison.sprt);
  }
  verdict.strength = estimate(mean(verdict.samples), variance(verdict.samples),
                              static_cast<int>(total(verdict.samples)));
  return verdict;
}

}  // namespace cls::orchestration::tournament
