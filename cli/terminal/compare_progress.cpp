// Progress of `cls compare`: the state of its test.
#include "cli/terminal/compare_progress.h"

#include <fmt/format.h>

#include <cmath>

namespace cls::cli {
namespace {

using namespace tournament;

constexpr std::chrono::seconds kLineInterval{10};

double samples_done(const ComparisonVerdict& known) {
  return league::total(known.samples) + known.left_out;
}

// To a fraction of one, and never "-0".
double rounded(double value, double fraction = 1) {
  return std::round(value * fraction) / fraction + 0.0;
}

std::string difference_text(const Comparison& comparison, const ComparisonVerdict& known) {
  const Estimate& strength = known.strength;
  if (in_goals(comparison.test.measure)) {
    const Estimate goals = estimate(known.samples);
    return fmt::format("{:+.2f} goals ({:+.2f}..{:+.2f})",
                       rounded(advantage(comparison, goals.score), 100),
                       advantage(comparison, goals.score_interval.low),
                       advantage(comparison, goals.score_interval.high));
  }

  if (is_direct(comparison)) {
    return fmt::format("{:+.0f} Elo ({:+.0f}..{:+.0f})", rounded(strength.elo),
                       strength.elo_interval.low, strength.elo_interval.high);
  }

  return fmt::format("{:+.1f} % ({:+.1f}..{:+.1f})", rounded(100 * gain(strength.score), 10),
                     100 * gain(strength.score_interval.low),
                     100 * gain(strength.score_interval.high));
}

// How far the test is.
std::string test_state(const Comparison& comparison, const ComparisonVerdict& known) {
  const Hypotheses& h = known.hypotheses;

  if (comparison.test.kind == TestKind::kSprt) {
    return fmt::format("LLR {:+.2f} ({:.2f}..{:+.2f})", rounded(known.llr, 100), lower_llr(h),
                       upper_llr(h));
  }
  return fmt::format("evidence {:.1f}/{:g} for, {:.1f}/{:g} against", known.betting.for_h1(),
                     1 / h.alpha, known.betting.for_h0(), 1 / h.beta);
}

}  // namespace

std::string comparison_status(const Comparison& comparison, const ComparisonVerdict& known,
                              const RunProgress& progress) {
  std::string text = fmt::format("{} {:.0f}", sample_name(comparison), samples_done(known));
  if (comparison.max_samples) text += fmt::format("/{}", *comparison.max_samples);
  if (league::total(known.samples) > 0) text += "  " + difference_text(comparison, known);
  text += "  " + test_state(comparison, known);

  if (progress.done_in_this_run > 0 && progress.seconds > 0) {
    const double seconds_per_match = progress.seconds / progress.done_in_this_run;
    text += "  " + time_left(expected_samples_left(comparison, known) *
                             matches_in_sample(comparison) * seconds_per_match);
  }

  return text;
}

std::string comparison_outlook(const Comparison& comparison, const ComparisonVerdict& known) {
  const double likely = std::ceil(expected_samples_left(comparison, known));
  const std::string_view samples = sample_name(comparison);
  if (samples_done(known) > 0) {
    return fmt::format("{} done: {:.0f}, to play: about {:.0f}", samples, samples_done(known),
                       likely);
  }

  const double most = std::ceil(max_expected_samples(comparison));
  if (most <= likely) return fmt::format("{} to play: {:.0f}", samples, likely);
  const bool goals = in_goals(comparison.test.measure);
  return fmt::format(
      "{} to play: {} if NEW wins all, about {:.0f} if it is better by --{}, {:.0f} halfway",
      samples, walkover_samples(comparison), likely,
      goals ? "goals0 or --goals1" : "elo0 or --elo1", most);
}

std::string CompareProgress::status(const RunProgress& progress) const {
  return comparison_status(comparison_, known_, progress);
}

bool CompareProgress::is_due(const RunProgress& /*progress*/,
                             std::chrono::steady_clock::duration since_last) {
  const double samples = samples_done(known_);
  const bool is_first = shown_samples_ == 0;
  if (samples <= shown_samples_ || (!is_first && since_last < kLineInterval)) return false;

  shown_samples_ = samples;
  return true;
}

}  // namespace cls::cli
