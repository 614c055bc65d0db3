// The sequential probability ratio test (SPRT): stops as soon as a hypothesis can be accepted.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "orchestration/tournament/rating/statistics.h"

namespace cls::orchestration::tournament {

/// H0: the Elo difference is `elo0`; H1: it is `elo1`. `alpha` is the probability to accept H1 when
/// H0 is true, `beta` the probability to accept H0 when H1 is true.
struct SprtSettings {
  double elo0 = 0.0;
  double elo1 = 40.0;
  double alpha = 0.05;
  double beta = 0.05;

  double lower() const;  ///< ln(beta / (1 - alpha)): H0 is accepted at or below
  double upper() const;  ///< ln((1 - beta) / alpha): H1 is accepted at or above
};

enum class SprtDecision { kOpen, kH0, kH1 };
std::string_view name(SprtDecision decision);

/// Counts of each outcome, from worst to best. The outcomes are equally spaced scores from 0 to 1:
/// three of a game (loss, draw, win), five of a pair of games on one seed with sides swapped,
/// nine of the difference of two such pairs.
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
  SprtDecision decision = SprtDecision::kOpen;
};

/// The state after `frequencies`. Open with fewer than kMinSprtResults results, because those do
/// not determine their own variance.
SprtState sprt_state(const Frequencies& frequencies, double score0, double score1,
                     const SprtSettings& settings);

inline constexpr int kMinSprtResults = 8;

/// The number of further results that the test needs on average from `llr` on, if the results have
/// this mean and variance: the exit time of a Brownian motion between the bounds.
double expected_results(double llr, double mean, double variance, double score0, double score1,
                        const SprtSettings& settings);

}  // namespace cls::orchestration::tournament
