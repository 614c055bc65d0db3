// The weights of situation_value(), from whole matches.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/play/flow.h"
#include "analysis/situations/situation_value.h"

namespace cls::analysis {

inline constexpr std::size_t kFigures = kFigureNames.size();

struct BookFit {
  int matches = 0;
  int windows = 0;
  std::array<double, kFigures> weights = {};
  /// Correlation of a window's value with the goal difference of its match: by all figures, and by
  /// goals alone.
  double correlation = 0.0;
  double correlation_of_goals = 0.0;
  /// Variance of a window's value within matches, in (goals a match)^2; by goals alone, scaled
  /// alike.
  double variance = 0.0;
  double variance_of_goals = 0.0;
};

/// Collects windows of whole matches: what a situation of as many cycles would have shown.
class BookFitter {
 public:
  /// `ridge`: how far the weights are shrunk towards those that each figure has alone, as a share
  /// of its variance.
  explicit BookFitter(int cycles, double ridge = kDefaultRidge) : cycles_(cycles), ridge_(ridge) {}
  static constexpr double kDefaultRidge = 3.0;

  /// Adds a whole match; its goal difference counts up to 5. Why it is left out, or an empty
  /// string.
  std::string add(const Flow& flow);

  /// Least squares of the goal difference of the other windows of a match, a window at a time,
  /// without an intercept: the sides are equal. The weights are then scaled so that values have the
  /// size of goal differences. Zero weights without matches of different strength.
  BookFit fit() const;

 private:
  struct Match {
    std::vector<std::array<double, kFigures>> windows;
    double difference = 0.0;  ///< goals a match of 6000 cycles
  };

  /// Scales the weights by the regression of the difference of a match on the mean value of its
  /// windows, and sets the correlations.
  void scale(BookFit& fit) const;

  int cycles_;
  double ridge_;
  std::vector<Match> matches_;
};

}  // namespace cls::analysis
