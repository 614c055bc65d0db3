// The sequential probability ratio test: stop as soon as the answer is known.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace cls::orchestration::tournament {

/// H0: the Elo difference is `elo0`; H1: it is `elo1`. `alpha` is the probability to accept H1
/// where H0 holds, `beta` the other way round.
struct SprtSettings {
  double elo0 = 0.0;
  double elo1 = 40.0;
  double alpha = 0.05;
  double beta = 0.05;

  double lower() const;  ///< ln(beta / (1 - alpha)): H0 is accepted at or below
  double upper() const;  ///< ln((1 - beta) / alpha): H1 is accepted at or above
};

enum class SprtAnswer { kOpen, kH0, kH1 };
std::string_view name(SprtAnswer answer);

/// How often each outcome came, from worst to best. The outcomes are equally spaced scores from 0
/// to 1: three of a game (loss, draw, win), five of a pair of games on one seed with sides swapped,
/// nine of the difference of two such pairs.
using Frequencies = std::vector<double>;

double mean(const Frequencies& frequencies);
double variance(const Frequencies& frequencies);
double total(const Frequencies& frequencies);

/// Log-likelihood ratio of the expected score being `score1` against `score0` (match-statistics
/// 8.3): multinomial model, each hypothesis with the distribution that maximises the likelihood of
/// what was seen under its expected score. An outcome that never came counts as a thousandth. 0
/// without results.
double log_likelihood_ratio(const Frequencies& frequencies, double score0, double score1);

/// The test on games or pairs.
struct SprtState {
  double llr = 0.0;
  SprtAnswer answer = SprtAnswer::kOpen;
};

/// The state after `frequencies`. Until there are kSprtMinimum results the answer is open: so few
/// say nothing about their own variance.
SprtState sprt_state(const Frequencies& frequencies, double score0, double score1,
                     const SprtSettings& settings);

inline constexpr int kSprtMinimum = 8;

}  // namespace cls::orchestration::tournament
