// Formulas of docs/spec/match-statistics.md 8 and 8.1.
#include "league/rating/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/confidence.h"

namespace cls::league {

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

namespace {

constexpr double kZ2 = base::kNormal95 * base::kNormal95;

// Wilson's interval, with the variance of the results in place of p (1 - p), which is that of wins
// and losses: as if z^2 results of the largest variance were there as well.
Interval wilson(double mean, double variance, double count) {
  const double center = (mean * count + kZ2 / 2) / (count + kZ2);
  const double half = base::kNormal95 / (count + kZ2) * std::sqrt(variance * count + kZ2 / 4);
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

}  // namespace

Interval wilson(double successes, double trials) {
  if (trials <= 0) return {0.0, 1.0};
  const double share = successes / trials;
  return wilson(share, share * (1 - share), trials);
}

double WinDrawLoss::score() const { return games() == 0 ? 0.5 : (won + drawn / 2.0) / games(); }

double WinDrawLoss::variance() const {
  if (games() == 0) return 0.0;
  const double s = score();
  return (won * (1 - s) * (1 - s) + drawn * (0.5 - s) * (0.5 - s) + lost * s * s) / games();
}

double elo_from_score(double score) {
  const double clamped = std::clamp(score, 1e-3, 1 - 1e-3);
  return 400 * std::log10(clamped / (1 - clamped));
}

double score_from_elo(double elo) { return 1 / (1 + std::pow(10.0, -elo / 400)); }

Estimate estimate(double score, double variance, int count) {
  constexpr int kMinNormalCount = 30;
  constexpr double kMinNormalPoints = 5.0;

  Estimate result;
  result.count = count;
  if (count <= 0) {
    result.elo_interval = {elo_from_score(0.0), elo_from_score(1.0)};
    return result;
  }

  const double error = std::sqrt(variance / count);
  const double min_points = count * std::min(score, 1 - score);
  result.score = score;
  const bool few = count < kMinNormalCount || min_points < kMinNormalPoints;
  result.score_interval = few ? wilson(score, variance, count)
                              : Interval{std::max(0.0, score - base::kNormal95 * error),
                                         std::min(1.0, score + base::kNormal95 * error)};

  result.elo = elo_from_score(score);
  result.elo_interval = {elo_from_score(result.score_interval.low),
                         elo_from_score(result.score_interval.high)};

  if (error > 0) {
    // Where Wilson's interval excludes 1/2, the likelihood is beyond 97.5 %.
    const double doubt = kZ2 / (4.0 * count * count);
    const double expected = few ? std::sqrt(variance / count + doubt) : error;
    result.superiority = normal_cdf((score - 0.5) / expected);
  } else if (score != 0.5) {
    const double doubt = std::pow(0.5, count + 1);
    result.superiority = score > 0.5 ? 1 - doubt : doubt;
  }
  return result;
}

}  // namespace cls::league
