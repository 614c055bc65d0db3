// Scores and Elo differences with their confidence intervals.
#pragma once

namespace cls::league {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Rounded to the four decimals of documents.
double rounded(double value);

/// Probability that a standard normal value is below `x`.
double normal_cdf(double x);

/// Wilson's interval (95 %) for a share of `successes` among `trials`; [0, 1] without trials.
/// `successes` may include halves for draws.
Interval wilson(double successes, double trials);

/// Wins, draws and losses of a team against another.
struct WinDrawLoss {
  int won = 0;
  int drawn = 0;
  int lost = 0;

  int games() const { return won + drawn + lost; }
  /// Share of the points with 1, 1/2, 0; 1/2 without games.
  double score() const;
  /// Variance of one game's score; 0 without games.
  double variance() const;
};

/// The Elo difference with the expected score `score`, which is clamped to 0.001 to 0.999, so that
/// all wins give 1200.
double elo_from_score(double score);
/// Expected score at an Elo difference.
double score_from_elo(double elo);

/// The strength of A against B from `count` results.
struct Estimate {
  int count = 0;
  double score = 0.5;
  Interval score_interval{0.0, 1.0};  ///< 95 %
  double elo = 0.0;
  Interval elo_interval;     ///< 95 %
  double superiority = 0.5;  ///< likelihood that the true score is above 1/2
};

/// From mean and variance of independent results within [0, 1], games or pairs. The interval is
/// normal; with fewer than 30 results, or fewer than 5 points lost or won, Wilson's with the
/// variance of the results, which is also valid for all wins. The likelihood of superiority agrees
/// with the interval. Without variance it follows from a flat prior: 1 - 2^-(count + 1) for all
/// wins.
Estimate estimate(double score, double variance, int count);

}  // namespace cls::league
