// Newton's method for the ratings, Gauss-Jordan elimination for their covariance.
#include "league/rating/bradley_terry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/confidence.h"
#include "base/index.h"
#include "league/rating/statistics.h"

namespace cls::league {
namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double kEloPerUnit = 173.71779276130073;  // 400 / ln 10
constexpr double kVirtualGames = 1.0;

double win_probability(double rating, double other) { return 1 / (1 + std::exp(other - rating)); }

// Points above the expected ones, by team.
std::vector<double> gradient(const std::vector<double>& rating,
                             std::span<const PairResults> results) {
  std::vector<double> surplus;
  for (const double one : rating)
    surplus.push_back(kVirtualGames * (0.5 - win_probability(one, 0.0)));
  for (const PairResults& pair : results) {
    const double expected = pair.games * win_probability(rating[base::index(pair.first)],
                                                         rating[base::index(pair.second)]);
    surplus[base::index(pair.first)] += pair.first_points - expected;
    surplus[base::index(pair.second)] -= pair.first_points - expected;
  }
  return surplus;
}

Matrix information(const std::vector<double>& rating, std::span<const PairResults> results) {
  Matrix matrix(rating.size(), std::vector<double>(rating.size()));
  for (std::size_t i = 0; i < rating.size(); ++i) {
    const double p = win_probability(rating[i], 0.0);
    matrix[i][i] = kVirtualGames * p * (1 - p);
  }
  for (const PairResults& pair : results) {
    const std::size_t i = base::index(pair.first);
    const std::size_t j = base::index(pair.second);
    const double p = win_probability(rating[i], rating[j]);
    const double known = pair.games * p * (1 - p);
    matrix[i][i] += known;
    matrix[j][j] += known;
    matrix[i][j] -= known;
    matrix[j][i] -= known;
  }
  return matrix;
}

// Diagonally dominant, so no pivot is ever small.
Matrix inverse(Matrix matrix) {
  const std::size_t size = matrix.size();
  Matrix result(size, std::vector<double>(size));
  for (std::size_t i = 0; i < size; ++i) result[i][i] = 1.0;

  for (std::size_t column = 0; column < size; ++column) {
    const double pivot = matrix[column][column];
    for (std::size_t k = 0; k < size; ++k) {
      matrix[column][k] /= pivot;
      result[column][k] /= pivot;
    }

    for (std::size_t row = 0; row < size; ++row) {
      const double factor = matrix[row][column];
      if (row == column || factor == 0.0) continue;
      for (std::size_t k = 0; k < size; ++k) {
        matrix[row][k] -= factor * matrix[column][k];
        result[row][k] -= factor * result[column][k];
      }
    }
  }
  return result;
}

// Newton's method on ln of the strengths; the average team has 0.
std::vector<double> fit(std::size_t teams, std::span<const PairResults> results) {
  constexpr int kMaxRounds = 100;
  constexpr double kConvergedStep = 1e-12;
  constexpr double kMaxStep = 1.0;
  std::vector<double> rating(teams);
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<double> surplus = gradient(rating, results);
    const Matrix covariance = inverse(information(rating, results));
    double change = 0.0;
    for (std::size_t i = 0; i < teams; ++i) {
      const double step =
          std::inner_product(surplus.begin(), surplus.end(), covariance[i].begin(), 0.0);
      rating[i] += std::clamp(step, -kMaxStep, kMaxStep);
      change = std::max(change, std::abs(step));
    }
    if (change < kConvergedStep) break;
  }
  return rating;
}

// Variance of team i's rating against the mean of all.
double variance_against_mean(const Matrix& covariance, std::size_t i) {
  const auto count = static_cast<double>(covariance.size());
  double row = 0.0;
  double all = 0.0;
  for (std::size_t j = 0; j < covariance.size(); ++j) {
    row += covariance[i][j];
    all += std::accumulate(covariance[j].begin(), covariance[j].end(), 0.0);
  }
  return covariance[i][i] - 2 * row / count + all / (count * count);
}

}  // namespace

Ratings fit_bradley_terry(int teams, std::span<const PairResults> results) {
  const std::size_t count = base::index(teams);
  const std::vector<double> rating = fit(count, results);
  const Matrix covariance = inverse(information(rating, results));
  const double middle =
      std::accumulate(rating.begin(), rating.end(), 0.0) / static_cast<double>(count);

  Ratings ratings;
  for (std::size_t i = 0; i < count; ++i) {
    ratings.elo.push_back(kEloPerUnit * (rating[i] - middle));
    ratings.error.push_back(kEloPerUnit * base::kNormal95 *
                            std::sqrt(std::max(0.0, variance_against_mean(covariance, i))));

    ratings.superiority.emplace_back();
    for (std::size_t j = 0; j < count; ++j) {
      const double spread = covariance[i][i] + covariance[j][j] - 2 * covariance[i][j];
      const double difference = rating[i] - rating[j];
      ratings.superiority.back().push_back(i == j ? 0.5
                                                  : normal_cdf(difference / std::sqrt(spread)));
    }
  }
  return ratings;
}

}  // namespace cls::league
