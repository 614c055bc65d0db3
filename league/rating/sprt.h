// The sequential probability ratio test (SPRT): stops as soon as a hypothesis can be accepted.
#pragma once

#include <vector>

#include "league/rating/hypotheses.h"
#include "league/rating/statistics.h"

namespace cls::league {

/// ln(beta / (1 - alpha)): H0 is accepted at or below.
double lower_llr(const Hypotheses& hypotheses);
/// ln((1 - beta) / alpha): H1 is accepted at or above.
double upper_llr(const Hypotheses& hypotheses);

/// Counts of each outcome, from worst to best. The outcomes are equally spaced scores from 0 to 1:
/// three of a game (loss, draw, win), five of a pair of games on one seed with sides swapped,
/// nine of the difference of two such pairs; more where goals count.
using Frequencies = std::vector<double>;

double mean(const Frequencies& frequencies);
double variance(const Frequencies& frequencies);
double total(const Frequencies& frequencies);

/// The strength that `frequencies` show; each of them is one result.
Estimate estimate(const Frequencies& frequencies);

/// Log-likelihood ratio of the expected score being `score1` against `score0`
/// (docs/spec/match-statistics.md 8.3): multinomial model, each hypothesis with the distribution
/// that maximizes the likelihood of the observed results under its expected score. An outcome that
/// never occurred counts as 0.001. Returns 0 without results.
double log_likelihood_ratio(const Frequencies& frequencies, double score0, double score1);

/// The state of a test on games or pairs.
struct SprtState {
  double llr = 0.0;
  Decision decision = Decision::kOpen;
};

/// The state after `frequencies`. Open with fewer than kMinSprtResults results, because those do
/// not determine their own variance.
SprtState sprt_state(const Frequencies& frequencies, const Hypotheses& hypotheses);

inline constexpr int kMinSprtResults = 8;

/// The number of further results that the test needs on average from `llr` on, if the results have
/// this mean and variance.
double expected_results(double llr, double mean, double variance, const Hypotheses& hypotheses);

}  // namespace cls::league
