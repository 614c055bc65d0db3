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
  if (is_direct(comparison)) return static_cast<std::size_t>(*points);
  return static_cast<std::size_t>(4 + *points - *half_points(sample, kBase));
}

void set_model(ComparisonVerdict& verdict, const Comparison& comparison) {
  const SprtSettings& sprt = comparison.sprt;
  const double gain0 = score_from_elo(sprt.elo0) - 0.5;
  const double gain1 = score_from_elo(sprt.elo1) - 0.5;
  if (is_direct(comparison)) {
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

// Of a sample's value when a fifth of the matches are draws and the matches of a pair share half of
// their randomness, as in the table of docs/tournaments.md.
double typical_variance(const Comparison& comparison) {
  constexpr double kOfPair = 0.15;
  return is_direct(comparison) ? kOfPair : kOfPair / 2;
}

double limited(const Comparison& comparison, double samples, double done) {
  if (!comparison.max_samples) return samples;
  return std::clamp(*comparison.max_samples - done, 0.0, samples);
}

}  // namespace

bool is_direct(const Comparison& comparison) { return opponents_of(comparison) == 0; }

std::string_view sample_name(const Comparison& comparison) {
  return is_direct(comparison) ? "pairs" : "quartets";
}

int matches_in_sample(const Comparison& comparison) { return is_direct(comparison) ? 2 : 4; }

double gain(double score) { return 2 * (score - 0.5); }

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
    matches = matches.first(std::min(matches.size(), static_cast<std::size_t>(*last)));
  }
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
  verdict.strength = estimate(verdict.samples);
  return verdict;
}

double expected_samples_left(const Comparison& comparison, const ComparisonVerdict& known) {
  if (known.state.decision != SprtDecision::kOpen) return 0.0;
  const double count = total(known.samples);
  const bool tells = count >= kMinSprtResults;
  const double left =
      expected_results(known.state.llr, tells ? mean(known.samples) : known.score0,
                       tells ? variance(known.samples) : typical_variance(comparison), known.score0,
                       known.score1, comparison.sprt);
  return limited(comparison, std::max(left, kMinSprtResults - count), count + known.left_out);
}

double max_expected_samples(const Comparison& comparison) {
  const ComparisonVerdict start = verdict(comparison, {});
  const double halfway = (start.score0 + start.score1) / 2;
  const double left = expected_results(0.0, halfway, typical_variance(comparison), start.score0,
                                       start.score1, comparison.sprt);
  return limited(comparison, std::max<double>(left, kMinSprtResults), 0.0);
}

}  // namespace cls::orchestration::tournament
