// A sequential test for bounded samples that adapts to the size of the difference: it bets.
#pragma once

#include <array>
#include <vector>

#include "league/rating/hypotheses.h"
#include "league/rating/statistics.h"

namespace cls::league {

/// Two players with a stake of 1 each. One bets in every round that the next sample is above
/// `mean0`, the other that it is below `mean1`. A bet gains or loses in proportion to the distance
/// of the sample from that mean, so that a player whose hypothesis is false does not gain on
/// average. By Ville's inequality the wealth of such a player ever reaches 1 / alpha with
/// probability alpha at most: the test is valid at every moment, for samples of any distribution
/// within 0 to 1. Waudby-Smith and Ramdas, "Estimating means of bounded random variables by
/// betting", JRSS B 86 (2024). docs/tournaments.md explains the strategy and lists error rates and
/// lengths.
class BettingTest {
 public:
  /// `typical_variance` of a sample is a first guess. It affects the length of the test, not its
  /// validity.
  explicit BettingTest(const Hypotheses& hypotheses = {}, double typical_variance = 0.15);

  /// A sample from 0 to 1. Samples after the decision have no effect on it.
  void add(double sample);

  /// The wealth of the player who bets on H1; H1 is accepted at 1 / alpha.
  double for_h1() const;
  /// The wealth of the player who bets on H0; H0 is accepted at 1 / beta.
  double for_h0() const;
  Decision decision() const { return decision_; }

  /// Bounds of the mean, valid at every moment: the true mean is ever below `low` with probability
  /// alpha at most, ever above `high` with probability beta at most. H1 was accepted exactly when
  /// `low` reached `mean0`, H0 when `high` reached `mean1`.
  Interval bounds() const;

  /// The number of further samples that the test needs on average if they have this mean and
  /// variance; an approximation.
  double expected_samples(double mean, double variance) const;

 private:
  struct Round {
    double sample = 0.0;
    double stake = 0.0;  // of the main strategy, per unit of the sample
  };
  // Logarithms of the wealth of each strategy.
  using Purse = std::array<double, 3>;

  double next_stake() const;
  Purse purse_after(double mean, bool mirrored) const;

  Hypotheses hypotheses_;
  double typical_variance_;
  std::vector<Round> rounds_;
  double sum_ = 0.0;
  double sum_of_squares_ = 0.0;
  Purse for_h1_{};
  Purse for_h0_{};
  Decision decision_ = Decision::kOpen;
};

}  // namespace cls::league
