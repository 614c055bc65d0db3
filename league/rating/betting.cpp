// Three betting strategies share the stake; each is optimal for another size of the difference.
#include "league/rating/betting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "league/rating/exit_time.h"

namespace cls::league {
namespace {

// The main strategy is Kelly's for a mean at the other hypothesis, with the variance estimated from
// the samples before; it takes about as long as the SPRT at its own hypotheses. The others bet a
// constant share of their wealth: all of it, which doubles with every sample of 1 against a mean of
// 1/2, and a third. Simulations chose the numbers (docs/tournaments.md).
constexpr double kMainShare = 0.64;
constexpr double kMaxMainBet = 0.9;  // of its wealth, so that it is never ruined
struct Hedge {
  double bet;    // share of its wealth
  double share;  // of the stake
};
constexpr std::array<Hedge, 2> kHedges = {{{1.0, 0.28}, {0.3, 0.08}}};
constexpr double kPriorSamples = 5.0;  // weight of the typical variance

// The return of a bet per unit when the sample is `sample` and the bet is against `mean`.
double log_return(double stake, double sample, double mean) {
  return std::log1p(std::max(-1.0, stake * (sample - mean)));
}

template <typename Purse>
void play(Purse& purse, double sample, double mean, double stake) {
  // At most the whole wealth is lost, when the sample is 0.
  purse[0] += log_return(std::min(stake, kMaxMainBet / mean), sample, mean);
  for (std::size_t i = 0; i < kHedges.size(); ++i) {
    purse[i + 1] += log_return(kHedges[i].bet / mean, sample, mean);
  }
}

template <typename Purse>
double wealth(const Purse& purse) {
  double sum = kMainShare * std::exp(purse[0]);
  for (std::size_t i = 0; i < kHedges.size(); ++i) {
    sum += kHedges[i].share * std::exp(purse[i + 1]);
  }
  return sum;
}

// Samples until a hedge that stands at `log_wealth` reaches `target`, if all samples have this mean
// and variance.
double hedge_samples(const Hedge& hedge, double log_wealth, double target, double sample_mean,
                     double variance, double mean) {
  const double stake = hedge.bet / mean;
  const double drift = stake * (sample_mean - mean);
  // Second order, but not below the return of equal samples.
  const double growth = std::log1p(std::max(-0.999, drift)) -
                        stake * stake * variance / (2 * (1 + drift) * (1 + drift));
  if (!(growth > 0) || !std::isfinite(log_wealth)) return std::numeric_limits<double>::infinity();
  return std::max(0.0, std::log(target / hedge.share) - log_wealth) / growth;
}

}  // namespace

BettingTest::BettingTest(const Hypotheses& hypotheses, double typical_variance)
    : hypotheses_(hypotheses), typical_variance_(typical_variance) {}

// Kelly's bet, to second order, from samples before this one only.
double BettingTest::next_stake() const {
  const auto count = static_cast<double>(rounds_.size());
  const double gap = hypotheses_.mean1 - hypotheses_.mean0;
  const double prior_mean = (hypotheses_.mean0 + hypotheses_.mean1) / 2;
  const double mean = (sum_ + kPriorSamples * prior_mean) / (count + kPriorSamples);
  const double squares = sum_of_squares_ - 2 * mean * sum_ + count * mean * mean;
  const double variance =
      (kPriorSamples * typical_variance_ + std::max(0.0, squares)) / (count + kPriorSamples);
  return gap / (variance + gap * gap);
}

void BettingTest::add(double sample) {
  const double stake = next_stake();
  rounds_.push_back({sample, stake});
  sum_ += sample;
  sum_of_squares_ += sample * sample;
  play(for_h1_, sample, hypotheses_.mean0, stake);
  play(for_h0_, 1 - sample, 1 - hypotheses_.mean1, stake);
  if (decision_ != Decision::kOpen) return;
  if (for_h1() >= 1 / hypotheses_.alpha) {
    decision_ = Decision::kH1;
  } else if (for_h0() >= 1 / hypotheses_.beta) {
    decision_ = Decision::kH0;
  }
}

double BettingTest::for_h1() const { return wealth(for_h1_); }
double BettingTest::for_h0() const { return wealth(for_h0_); }

BettingTest::Purse BettingTest::purse_after(double mean, bool mirrored) const {
  Purse purse{};
  for (const Round& round : rounds_) {
    play(purse, mirrored ? 1 - round.sample : round.sample, mean, round.stake);
  }
  return purse;
}

// The wealth decreases with the mean that is bet against: bisection.
Interval BettingTest::bounds() const {
  constexpr int kBisections = 40;
  const auto bound = [&](double target, bool mirrored) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + high) / 2;
      (wealth(purse_after(middle, mirrored)) >= target ? low : high) = middle;
    }
    return low;
  };
  return {bound(1 / hypotheses_.alpha, false), 1 - bound(1 / hypotheses_.beta, true)};
}

double BettingTest::expected_samples(double mean, double variance) const {
  if (decision_ != Decision::kOpen) return 0.0;
  // The main strategies of both players are each other's mirror image, so their wealth is that of
  // one random walk, which both shares of the stake make longer.
  const Hypotheses& h = hypotheses_;
  const double walk = (for_h1_[0] - for_h0_[0]) / 2;
  double samples =
      exit_time(walk, -std::log(1 / (h.beta * kMainShare)), std::log(1 / (h.alpha * kMainShare)),
                walk_of_mean(mean, variance, h.mean0, h.mean1));
  for (std::size_t i = 0; i < kHedges.size(); ++i) {
    samples = std::min(
        {samples, hedge_samples(kHedges[i], for_h1_[i + 1], 1 / h.alpha, mean, variance, h.mean0),
         hedge_samples(kHedges[i], for_h0_[i + 1], 1 / h.beta, 1 - mean, variance, 1 - h.mean1)});
  }
  return samples;
}

}  // namespace cls::league
