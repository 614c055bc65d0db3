// Formulas of docs/spec/match-statistics.md 8 and 8.1.
#include "league/rating/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/confidence.h"

namespace cls::league {

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

Interval wilson(double successes, double trials) {
  if (trials <= 0) return {0.0, 1.0};
  constexpr double z2 = base::kNormal95 * base::kNormal95;
  const double center = (successes + z2 / 2) / (trials + z2);
  const double spread = successes * (trials - successes) / trials + z2 / 4;
  const double half = base::kNormal95 / (trials + z2) * std::sqrt(spread);
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
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
  result.score_interval = few ? wilson(score * count, count)
                              : Interval{std::max(0.0, score - base::kNormal95 * error),
                                         std::min(1.0, score + base::kNormal95 * error)};

  result.elo = elo_from_score(score);
  result.elo_interval = {elo_from_score(result.score_interval.low),
                         elo_from_score(result.score_interval.high)};

  if (error > 0) {
    // Few results do not determine their own variance. Use that of a score of one half, as Wilson's
    // interval does, so that both agree.
    const double expected = few ? 0.5 / std::sqrt(count) : error;
    result.superiority = normal_cdf((score - 0.5) / expected);
  } else if (score != 0.5) {
    const double doubt = std::pow(0.5, count + 1);
    result.superiority = score > 0.5 ? 1 - doubt : doubt;
  }
  return result;
}

}  // namespace cls::league
