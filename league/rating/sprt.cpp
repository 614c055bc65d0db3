// Generalized SPRT on a multinomial distribution.
#include "league/rating/sprt.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "league/rating/exit_time.h"

namespace cls::league {
namespace {

constexpr double kUnobservedCount = 1e-3;

double score_at(std::size_t outcome, std::size_t outcomes) {
  return static_cast<double>(outcome) / static_cast<double>(outcomes - 1);
}

// The Lagrange multiplier of the most likely distribution with expectation `target`: the root of
// sum p (a - s) / (1 + x (a - s)), which decreases between two poles.
double multiplier(const std::vector<double>& share, double target) {
  constexpr double kMargin = 1e-9;
  constexpr int kBisections = 100;
  double low = -1 / (1 - target);
  double high = 1 / target;
  const double width = high - low;
  low += kMargin * width;
  high -= kMargin * width;
  for (int i = 0; i < kBisections; ++i) {
    const double x = (low + high) / 2;
    double sum = 0.0;
    for (std::size_t k = 0; k < share.size(); ++k) {
      const double away = score_at(k, share.size()) - target;
      sum += share[k] * away / (1 + x * away);
    }
    (sum > 0 ? low : high) = x;
  }
  return (low + high) / 2;
}

}  // namespace

double lower_llr(const Hypotheses& hypotheses) {
  return std::log(hypotheses.beta / (1 - hypotheses.alpha));
}

double upper_llr(const Hypotheses& hypotheses) {
  return std::log((1 - hypotheses.beta) / hypotheses.alpha);
}

double total(const Frequencies& frequencies) {
  return std::accumulate(frequencies.begin(), frequencies.end(), 0.0);
}

double mean(const Frequencies& frequencies) {
  const double count = total(frequencies);
  if (count <= 0) return 0.5;
  double sum = 0.0;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    sum += frequencies[k] * score_at(k, frequencies.size());
  }
  return sum / count;
}

double variance(const Frequencies& frequencies) {
  const double count = total(frequencies);
  if (count <= 0) return 0.0;
  const double center = mean(frequencies);
  double sum = 0.0;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const double away = score_at(k, frequencies.size()) - center;
    sum += frequencies[k] * away * away;
  }
  return sum / count;
}

Estimate estimate(const Frequencies& frequencies) {
  return estimate(mean(frequencies), variance(frequencies), static_cast<int>(total(frequencies)));
}

double log_likelihood_ratio(const Frequencies& frequencies, double score0, double score1) {
  if (total(frequencies) <= 0) return 0.0;
  std::vector<double> share(frequencies);
  for (double& one : share) one = std::max(one, kUnobservedCount);
  const double count = total(share);
  for (double& one : share) one /= count;
  const double x0 = multiplier(share, score0);
  const double x1 = multiplier(share, score1);
  double sum = 0.0;
  for (std::size_t k = 0; k < share.size(); ++k) {
    const double at = score_at(k, share.size());
    sum += share[k] * std::log((1 + x0 * (at - score0)) / (1 + x1 * (at - score1)));
  }
  return count * sum;
}

SprtState sprt_state(const Frequencies& frequencies, const Hypotheses& hypotheses) {
  SprtState state;
  state.llr = log_likelihood_ratio(frequencies, hypotheses.mean0, hypotheses.mean1);
  if (total(frequencies) < kMinSprtResults) return state;
  if (state.llr >= upper_llr(hypotheses)) state.decision = Decision::kH1;
  if (state.llr <= lower_llr(hypotheses)) state.decision = Decision::kH0;
  return state;
}

double expected_results(double llr, double mean, double variance, const Hypotheses& hypotheses) {
  return exit_time(llr, lower_llr(hypotheses), upper_llr(hypotheses),
                   walk_of_mean(mean, variance, hypotheses.mean0, hypotheses.mean1));
}

}  // namespace cls::league
