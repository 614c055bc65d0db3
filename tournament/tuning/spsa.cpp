// Simultaneous perturbation stochastic approximation.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tournament/tuning/optimizer.h"

namespace cls::tournament {
namespace {

// Spall's exponents, and the share of generations after which the gain begins to decrease.
constexpr double kGainExponent = 0.602;
constexpr double kStepExponent = 0.101;
constexpr double kStability = 0.1;

class Spsa : public Optimizer {
 public:
  Spsa(const SearchSpace& space, int generations, std::uint64_t seed)
      : space_(space),
        stability_(kStability * std::max(1, generations)),
        random_(seed, "spsa"),
        mean_(space.start) {}

  std::vector<Point> ask() override {
    constexpr int kDraws = 100;
    for (int i = 0; i < kDraws; ++i) {
      for (std::size_t k = 0; k < mean_.size(); ++k) place_pair(k, random_.bernoulli(0.5));
      if (space_.valid(plus_) && space_.valid(minus_)) return {plus_, minus_};
    }
    // The guess is valid, in a corner of the valid points.
    if (!space_.valid(plus_)) plus_ = mean_;
    if (!space_.valid(minus_)) minus_ = mean_;
    return {plus_, minus_};
  }

  void tell(const std::vector<double>& values) override {
    const double gain = std::pow((stability_ + 1) / (stability_ + generation_ + 1), kGainExponent);
    const double difference = values[0] - values[1];
    Point next = mean_;
    for (std::size_t k = 0; k < next.size(); ++k) {
      const double direction = plus_[k] == minus_[k] ? 0.0 : plus_[k] > minus_[k] ? 1.0 : -1.0;
      next[k] = std::clamp(next[k] + gain * difference * direction * space_.steps[k], 0.0, 1.0);
    }
    move_to(next);
    ++generation_;
  }

  Point best() const override { return mean_; }

  Point spread() const override {
    Point spread(mean_.size());
    for (std::size_t k = 0; k < spread.size(); ++k) spread[k] = step(k);
    return spread;
  }

 private:
  double step(std::size_t k) const {
    const double shrunk = space_.steps[k] / std::pow(generation_ + 1, kStepExponent);
    return std::max(shrunk, space_.min_steps[k]);
  }

  // At a constraint only the coordinates move that may.
  void move_to(const Point& next) {
    if (space_.valid(next)) {
      mean_ = next;
      return;
    }
    for (std::size_t k = 0; k < next.size(); ++k) {
      const double before = std::exchange(mean_[k], next[k]);
      if (!space_.valid(mean_)) mean_[k] = before;
    }
  }

  // Both points keep their distance where the guess is near a bound.
  void place_pair(std::size_t k, bool up) {
    const double size = std::min(step(k), 0.5);
    const double center = std::clamp(mean_[k], size, 1 - size);
    plus_.resize(mean_.size());
    minus_.resize(mean_.size());
    plus_[k] = up ? center + size : center - size;
    minus_[k] = up ? center - size : center + size;
  }

  SearchSpace space_;
  double stability_;
  soccer::RandomStream random_;
  Point mean_;
  Point plus_;
  Point minus_;
  int generation_ = 0;
};

}  // namespace

std::unique_ptr<Optimizer> make_spsa(const SearchSpace& space, int generations,
                                     std::uint64_t seed) {
  return std::make_unique<Spsa>(space, generations, seed);
}

}  // namespace cls::tournament
