// CMA-ES with rank-one and rank-mu updates, equations and constants of the tutorial.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "tournament/tuning/optimizer.h"
#include "tournament/tuning/symmetric_matrix.h"

namespace cls::tournament {
namespace {

// Strategy constants for `n` dimensions (tutorial, table 1; positive weights only).
struct Constants {
  explicit Constants(std::size_t dimensions, int population) {
    const auto n = static_cast<double>(dimensions);
    count = population > 0 ? static_cast<std::size_t>(population)
                           : 4 + static_cast<std::size_t>(3 * std::log(n));
    const std::size_t parents = count / 2;
    for (std::size_t i = 0; i < parents; ++i) {
      weights.push_back(std::log((static_cast<double>(count) + 1) / 2) -
                        std::log(static_cast<double>(i) + 1));
    }

    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double squares = 0.0;
    for (double& weight : weights) {
      weight /= sum;
      squares += weight * weight;
    }

    mass = 1 / squares;
    sigma_rate = (mass + 2) / (n + mass + 5);
    damping = 1 + 2 * std::max(0.0, std::sqrt((mass - 1) / (n + 1)) - 1) + sigma_rate;
    path_rate = (4 + mass / n) / (n + 4 + 2 * mass / n);
    rank_one = 2 / ((n + 1.3) * (n + 1.3) + mass);
    rank_mu = std::min(1 - rank_one, 2 * (mass - 2 + 1 / mass) / ((n + 2) * (n + 2) + mass));
    expected_length = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  }

  std::size_t count;
  std::vector<double> weights;
  double mass;  // variance-effective number of parents
  double sigma_rate;
  double damping;
  double path_rate;
  double rank_one;
  double rank_mu;
  double expected_length;  // of a standard normal vector
};

// Works in coordinates divided by the first steps, so that the first covariance is the identity.
class CmaEs : public Optimizer {
 public:
  CmaEs(const SearchSpace& space, int population, std::uint64_t seed)
      : space_(space),
        n_(space.start.size()),
        constants_(n_, population),
        random_(seed, "cma-es"),
        covariance_(SymmetricMatrix::identity(n_)),
        axes_(eigen_decomposition(covariance_)),
        path_(n_),
        sigma_path_(n_) {
    mean_ = space.start;
  }

  std::vector<Point> ask() override {
    axes_ = eigen_decomposition(covariance_);
    trials_.clear();
    while (trials_.size() < constants_.count) trials_.push_back(valid_trial());
    return trials_;
  }

  void tell(const std::vector<double>& values) override {
    std::vector<std::size_t> order(trials_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return values[i]; });

    // Steps of the parents in units of sigma.
    std::vector<Point> steps;
    Point mean_step(n_);
    for (std::size_t i = 0; i < constants_.weights.size(); ++i) {
      Point step(n_);
      for (std::size_t k = 0; k < n_; ++k) {
        step[k] = (trials_[order[i]][k] - mean_[k]) / (space_.steps[k] * sigma_);
        mean_step[k] += constants_.weights[i] * step[k];
      }
      steps.push_back(std::move(step));
    }

    for (std::size_t k = 0; k < n_; ++k) mean_[k] += sigma_ * space_.steps[k] * mean_step[k];
    update_paths(mean_step);
    update_covariance(steps);
    means_.push_back(mean_);
    ++generation_;
  }

  // The mean of the latest means: with noise each of them is as far off as a step.
  Point best() const override {
    if (means_.empty()) return mean_;
    const std::size_t count = (means_.size() + 2) / 3;
    Point sum(n_);
    for (std::size_t i = means_.size() - count; i < means_.size(); ++i) {
      for (std::size_t k = 0; k < n_; ++k) sum[k] += means_[i][k] / static_cast<double>(count);
    }
    return space_.valid(clamped(sum)) ? clamped(sum) : clamped(mean_);
  }

  Point spread() const override {
    Point spread(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      spread[k] = sigma_ * space_.steps[k] * std::sqrt(covariance_(k, k));
    }
    return spread;
  }

 private:
  static Point clamped(Point point) {
    for (double& one : point) one = std::clamp(one, 0.0, 1.0);
    return point;
  }

  // Draws until a point is inside; then moves the last one towards the mean, which is valid.
  Point valid_trial() {
    constexpr int kDraws = 100;
    constexpr int kHalvings = 40;
    Point trial;
    for (int i = 0; i < kDraws; ++i) {
      trial = draw();
      const Point inside = clamped(trial);
      if (inside == trial && space_.valid(trial)) return trial;
    }
    trial = clamped(trial);
    for (int i = 0; i < kHalvings && !space_.valid(trial); ++i) {
      for (std::size_t k = 0; k < n_; ++k) trial[k] = (trial[k] + mean_[k]) / 2;
    }
    return space_.valid(trial) ? clamped(trial) : space_.start;
  }

  Point draw() {
    Point normal(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      normal[k] = axes_.roots[k] * random_.normal(0.0, 1.0);
    }
    Point trial(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      double step = 0.0;
      for (std::size_t j = 0; j < n_; ++j) step += axes_.vectors(k, j) * normal[j];
      const double width = sigma_ * space_.steps[k] * std::sqrt(covariance_(k, k));
      const double wider = std::max(1.0, space_.min_steps[k] / width);
      trial[k] = mean_[k] + wider * sigma_ * space_.steps[k] * step;
    }
    return trial;
  }

  void update_paths(const Point& mean_step) {
    const Constants& c = constants_;
    // The step with the covariance undone: B D^-1 B^T.
    Point in_axes(n_);
    for (std::size_t j = 0; j < n_; ++j) {
      for (std::size_t k = 0; k < n_; ++k) in_axes[j] += axes_.vectors(k, j) * mean_step[k];
      in_axes[j] /= axes_.roots[j];
    }

    double square = 0.0;
    for (std::size_t k = 0; k < n_; ++k) {
      double whitened = 0.0;
      for (std::size_t j = 0; j < n_; ++j) whitened += axes_.vectors(k, j) * in_axes[j];
      sigma_path_[k] = (1 - c.sigma_rate) * sigma_path_[k] +
                       std::sqrt(c.sigma_rate * (2 - c.sigma_rate) * c.mass) * whitened;
      square += sigma_path_[k] * sigma_path_[k];
    }

    const double length = std::sqrt(square);
    const double settled = std::sqrt(1 - std::pow(1 - c.sigma_rate, 2.0 * (generation_ + 1)));
    const auto n = static_cast<double>(n_);
    grows_ = length / settled < (1.4 + 2 / (n + 1)) * c.expected_length;

    for (std::size_t k = 0; k < n_; ++k) {
      path_[k] = (1 - c.path_rate) * path_[k];
      if (grows_) path_[k] += std::sqrt(c.path_rate * (2 - c.path_rate) * c.mass) * mean_step[k];
    }

    const double change = (c.sigma_rate / c.damping) * (length / c.expected_length - 1);
    sigma_ = std::min(kMaxSigma, sigma_ * std::exp(std::min(1.0, change)));
  }

  void update_covariance(const std::vector<Point>& steps) {
    const Constants& c = constants_;
    const double stalled = grows_ ? 0.0 : c.rank_one * c.path_rate * (2 - c.path_rate);
    const double keep = 1 - c.rank_one - c.rank_mu + stalled;
    for (std::size_t row = 0; row < n_; ++row) {
      for (std::size_t column = 0; column <= row; ++column) {
        double sum = keep * covariance_(row, column) + c.rank_one * path_[row] * path_[column];
        for (std::size_t i = 0; i < steps.size(); ++i) {
          sum += c.rank_mu * c.weights[i] * steps[i][row] * steps[i][column];
        }
        covariance_.set(row, column, sum);
      }
    }
  }

  static constexpr double kMaxSigma = 4.0;  // the cube is not much larger than the first steps

  SearchSpace space_;
  std::size_t n_;
  Constants constants_;
  soccer::RandomStream random_;
  SymmetricMatrix covariance_;
  EigenDecomposition axes_;
  Point path_;
  Point sigma_path_;
  Point mean_;
  std::vector<Point> means_;  // after each generation
  double sigma_ = 1.0;
  bool grows_ = true;
  int generation_ = 0;
  std::vector<Point> trials_;
};

}  // namespace

std::unique_ptr<Optimizer> make_cma_es(const SearchSpace& space, int population,
                                       std::uint64_t seed) {
  return std::make_unique<CmaEs>(space, population, seed);
}

}  // namespace cls::tournament
