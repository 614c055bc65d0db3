// Least squares over windows of whole matches.
#include "analysis/situations/book_fit.h"

#include <algorithm>
#include <cmath>

#include "analysis/situations/linear_system.h"

namespace cls::analysis {
namespace {

constexpr double kMatchCycles = 6000.0;
constexpr double kMaxDifference = 5.0;
constexpr std::size_t kMinWindows = 5;

using FigureRow = Row<kFigures>;

// Figures that depend on each other share their weight; unused ones get 0.
FigureRow solve_with_ridge(Matrix<kFigures> a, const FigureRow& b, double ridge) {
  for (std::size_t i = 0; i < kFigures; ++i) a[i][i] = a[i][i] * (1.0 + ridge) + 1e-9;
  return solve(a, b);
}

struct Moments2 {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  void add(double x, double y) {
    xx += x * x;
    yy += y * y;
    xy += x * y;
  }
  double correlation() const { return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0.0; }
};

// The sum of the squared deviations of values of windows from the mean of their match.
double deviations(const auto& matches, auto value_of) {
  double sum = 0.0;
  for (const auto& match : matches) {
    double mean = 0.0;
    const auto count = static_cast<double>(match.windows.size());
    for (const FigureRow& window : match.windows) mean += value_of(window) / count;
    for (const FigureRow& window : match.windows) sum += std::pow(value_of(window) - mean, 2);
  }
  return sum;
}

}  // namespace

std::string BookFitter::add(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  if (record.frames() < 2) return "the log has no frames";

  Match match;
  std::size_t begin = 0;
  while (begin + 1 < record.frames()) {
    // A window has as many cycles of game time; stopped ones count as those before a kick-off do.
    std::size_t end = begin + 1;
    while (end < record.frames() && record.time[end] < record.time[begin] + cycles_) ++end;

    if (record.time[end - 1] - record.time[begin] < cycles_ / 2) break;
    if (record.mode[begin] == soccer::PlayMode::kPlayOn) {
      match.windows.push_back(figures_of(flow, begin, std::min(end + 1, record.frames())).values());
    }
    begin = end;
  }
  if (match.windows.size() < kMinWindows) return "the match is too short";

  const int length = record.time[record.frames() - 1] - record.time[0];
  const auto& teams = record.final_teams();
  const double difference = (teams[0].score - teams[1].score) * kMatchCycles / std::max(length, 1);
  match.difference = std::clamp(difference, -kMaxDifference, kMaxDifference);
  matches_.push_back(std::move(match));
  return {};
}

BookFit BookFitter::fit() const {
  BookFit fit;
  fit.matches = static_cast<int>(matches_.size());

  Matrix<kFigures> products{};
  FigureRow targets{};
  for (const Match& match : matches_) {
    for (const FigureRow& window : match.windows) {
      ++fit.windows;
      // The goals of the window itself are left out: they would explain themselves.
      const double rest = match.difference - window[0];
      for (std::size_t i = 0; i < kFigures; ++i) {
        targets[i] += window[i] * rest;
        for (std::size_t j = 0; j < kFigures; ++j) products[i][j] += window[i] * window[j];
      }
    }
  }
  if (fit.windows == 0) return fit;
  fit.weights = solve_with_ridge(products, targets, ridge_);

  scale(fit);
  const auto value_of = [&](const FigureRow& window) { return dot(fit.weights, window); };
  const double share = cycles_ / kMatchCycles;
  const auto goals_of = [&](const FigureRow& window) { return window[0] / share; };
  fit.variance = deviations(matches_, value_of) / fit.windows;
  fit.variance_of_goals = deviations(matches_, goals_of) / fit.windows;
  return fit;
}

void BookFitter::scale(BookFit& fit) const {
  Moments2 means;
  Moments2 windows;
  Moments2 goals;
  for (const Match& match : matches_) {
    double mean = 0.0;
    for (const FigureRow& window : match.windows) {
      const double value = dot(fit.weights, window);
      mean += value / static_cast<double>(match.windows.size());
      windows.add(value, match.difference);
      goals.add(window[0], match.difference);
    }
    means.add(mean, match.difference);
  }

  const double factor = means.xx > 0 ? means.xy / means.xx : 0.0;
  for (double& weight : fit.weights) weight *= factor;
  fit.correlation = windows.correlation();
  fit.correlation_of_goals = goals.correlation();
}

}  // namespace cls::analysis
