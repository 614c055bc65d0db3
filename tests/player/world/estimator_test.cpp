// Numerical tools of the estimators: truncated normals, distance quantization, assignment, Gaussian
// updates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "player/tracking/assignment.h"
#include "player/world/gaussian.h"
#include "player/world/seen_distance.h"
#include "player/world/truncated_normal.h"
#include "player/world/view_cone.h"
#include "soccer/math.h"
#include "soccer/random.h"

namespace cls::player {
namespace {

namespace math = soccer::math;

/// Moments of a standard normal on [low, high] by numerical integration.
Moments integrated_moments(double low, double high) {
  const double peak = std::clamp(0.0, low, high);
  const double from = std::max(low, peak - 9.0);
  const double to = std::min(high, peak + 9.0);
  constexpr int kCells = 4000;
  double weight = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double x = from + (to - from) * (i + 0.5) / kCells - peak;
    const double density = math::exp(-0.5 * x * x - x * peak);
    weight += density;
    first += density * x;
    second += density * x * x;
  }
  const double mean = first / weight;
  return {mean + peak, second / weight - mean * mean};
}

TEST(TruncatedNormal, MatchesNumericalIntegrationInBulkAndTails) {
  for (double low = -7.9; low < 8.0; low += 0.317) {
    for (const double width : {0.01, 0.1, 0.3, 1.0, 2.5, 6.0, 20.0}) {
      const Moments expected = integrated_moments(low, low + width);
      const Moments got = truncated({0.0, 1.0}, low, low + width);
      const double deviation = std::sqrt(expected.variance);
      EXPECT_NEAR(got.mean, expected.mean, 0.04 * deviation) << low << " " << width;
      EXPECT_NEAR(got.variance, expected.variance, 0.08 * expected.variance) << low << " " << width;
    }
  }
}

TEST(TruncatedNormal, ScalesAndShifts) {
  const Moments standard = truncated({0.0, 1.0}, -0.5, 1.0);
  const Moments scaled = truncated({3.0, 4.0}, 2.0, 5.0);
  EXPECT_NEAR(scaled.mean, 3.0 + 2.0 * standard.mean, 1e-12);
  EXPECT_NEAR(scaled.variance, 4.0 * standard.variance, 1e-12);
}

/// The server's quantization with the focus point at the observer
/// (docs/spec/simulation-model.md 7.4).
double printed(double distance, double step) {
  return math::quantize(math::exp(math::quantize(math::log(distance + math::kEps), step)), 0.1);
}

TEST(SeenDistance, RangeContainsExactlyTheDistancesWithThatPrintedValue) {
  for (const double step : {0.1, 0.01}) {
    const DistanceTable table(step);
    for (double d = 0.02; d < 120.0; d *= 1.0007) {
      const DistanceRange range = table.range(printed(d, step));
      EXPECT_LE(range.low, d + 1e-9) << step;
      EXPECT_GE(range.high, d - 1e-9) << step;
      if (range.low > 0.01) {
        EXPECT_NE(printed(range.low * (1 - 1e-6), step), printed(range.low * (1 + 1e-6), step));
      }
      EXPECT_NE(printed(range.high * (1 - 1e-6), step), printed(range.high * (1 + 1e-6), step));
    }
  }
}

double rounding_error(double d) {
  return d - math::exp(math::quantize(math::log(d + math::kEps), 0.1));
}

/// Printed value with the focus point at distance `f` from the object, before the last rounding.
double unrounded(double d, double f) {
  return std::max(0.0, d - (rounding_error(f) + rounding_error(d)) / 2.0);
}

TEST(SeenDistance, RangeContainsTrueDistanceForUncertainFocusPoint) {
  const DistanceTable table(0.1);
  soccer::RandomStream random(8, "focus");
  for (int i = 0; i < 3000; ++i) {
    const double d = random.uniform(0.5, 60.0);
    const double f = random.uniform(0.0, 60.0);
    const double error = random.uniform(0.0, 2.0);
    const double estimated = std::max(0.0, f + random.uniform(-error, error));
    const double seen = math::quantize(unrounded(d, f), 0.1);
    const DistanceRange range = table.range(seen, estimated, error);
    EXPECT_LE(range.low, d + 1e-9) << d << " " << f << " " << estimated << " " << error;
    EXPECT_GE(range.high, d - 1e-9) << d << " " << f << " " << estimated << " " << error;
    EXPECT_LT(range.high - range.low, 0.1 * (d + f) + 0.3 + error);
  }
}

TEST(SeenDistance, RangeAlongRayMatchesExhaustiveSearch) {
  const DistanceTable table(0.1);
  soccer::RandomStream random(9, "ray");
  for (int i = 0; i < 300; ++i) {
    const soccer::Vec2 eye{random.uniform(-50.0, 50.0), random.uniform(-30.0, 30.0)};
    const soccer::Vec2 direction = soccer::polar_degrees(1.0, random.uniform(-180.0, 180.0));
    const double d = random.uniform(1.0, 50.0);
    // Near the object, or anywhere.
    const double near = i % 2 == 0 ? 2.0 : 40.0;
    const soccer::Vec2 focus =
        i % 2 == 0
            ? eye + direction * d +
                  soccer::polar_degrees(random.uniform(0.0, near), random.uniform(-180.0, 180.0))
            : eye + soccer::polar_degrees(random.uniform(0.0, near), random.uniform(-180.0, 180.0));
    const auto at = [&](double distance) {
      return unrounded(distance, soccer::distance(eye + direction * distance, focus));
    };
    const double seen = math::quantize(at(d), 0.1);
    DistanceRange tried{1e9, -1e9};
    for (double t = 0.05; t < 1.5 * d + 5.0; t += 2e-3) {
      if (std::fabs(at(t) - seen) > 0.05) continue;
      tried.low = std::min(tried.low, t);
      tried.high = std::max(tried.high, t);
    }
    const DistanceRange range = table.range_along(seen, eye, direction, focus);
    EXPECT_LE(range.low, d + 1e-6) << i;
    EXPECT_GE(range.high, d - 1e-6) << i;
    EXPECT_NEAR(range.low, tried.low, 0.02) << i << " d " << d << " seen " << seen;
    EXPECT_NEAR(range.high, tried.high, 0.02) << i << " d " << d << " seen " << seen;
  }
}

TEST(Assignment, FindsMinimumTotalCost) {
  soccer::RandomStream random(3, "assignment");
  for (int round = 0; round < 500; ++round) {
    CostTable table;
    table.rows = 1 + static_cast<std::size_t>(round) % 5;
    table.columns = table.rows + static_cast<std::size_t>(round / 5) % 3;
    for (std::size_t r = 0; r < table.rows; ++r) {
      for (std::size_t c = 0; c < table.columns; ++c) {
        table.cost[r][c] = std::floor(random.uniform(-5.0, 15.0));
      }
    }
    const auto column_of = assign(table);
    double total = 0.0;
    std::vector<bool> used(table.columns);
    for (std::size_t r = 0; r < table.rows; ++r) {
      EXPECT_FALSE(used[column_of[r]]);
      used[column_of[r]] = true;
      total += table.cost[r][column_of[r]];
    }
    std::vector<std::size_t> order(table.columns);
    std::iota(order.begin(), order.end(), 0U);
    double least = 1e9;
    do {
      double sum = 0.0;
      for (std::size_t r = 0; r < table.rows; ++r) sum += table.cost[r][order[r]];
      least = std::min(least, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_DOUBLE_EQ(total, least);
  }
}

TEST(Gaussian, ConvergesToCenterOfFeasibleRegion) {
  // The triangle x >= 0, y >= 0, x + y <= 1 with a flat prior: its center is at one third.
  Gaussian<2> estimate;
  estimate.at(0, 0) = estimate.at(1, 1) = 100.0;
  const std::array<Slab<2>, 3> slabs = {
      {{{1.0, 0.0}, 0.0, 50.0, 0.0}, {{0.0, 1.0}, 0.0, 50.0, 0.0}, {{1.0, 1.0}, -50.0, 1.0, 0.0}}};
  condition<2>(estimate, slabs, 10);
  EXPECT_NEAR(estimate.mean[0], 1.0 / 3.0, 0.03);
  EXPECT_NEAR(estimate.mean[1], 1.0 / 3.0, 0.03);
  EXPECT_NEAR(estimate.at(0, 0), 1.0 / 18.0, 0.015);
  EXPECT_NEAR(estimate.at(0, 1), -1.0 / 36.0, 0.01);
}

TEST(Gaussian, NoiseWeakensSlab) {
  Gaussian<1> sharp;
  sharp.at(0, 0) = 1.0;
  Gaussian<1> soft = sharp;
  condition<1>(sharp, Slab<1>{{1.0}, 1.0, 1.2, 0.0});
  condition<1>(soft, Slab<1>{{1.0}, 1.0, 1.2, 1.0});
  EXPECT_NEAR(sharp.mean[0], 1.1, 0.01);
  EXPECT_NEAR(soft.mean[0], 0.55, 0.01);
  EXPECT_NEAR(soft.at(0, 0), 0.5, 0.01);
}

TEST(Gaussian, UpdateKeepsWhatIsKnownExactly) {
  Gaussian<3> pose;
  pose.mean = {1.0, 2.0, 30.0};
  const VecN<3> gain = covariance_with(pose, {0.0, 0.0, -1.0});
  rank_one_update(pose, gain, 0.0, 0.0, 0.0);
  EXPECT_EQ(pose.mean, (VecN<3>{1.0, 2.0, 30.0}));
  EXPECT_EQ(pose.covariance, (std::array<double, 9>{}));
}

TEST(ViewMemory, DirectionThatIsNotANumberHasNoSectors) {
  ViewMemory view;
  for (int& age : view.ages) age = 3;
  EXPECT_EQ(view.age_around(soccer::AngleDeg(std::nan("")), 30.0), 0);
  EXPECT_EQ(view.age_around(soccer::AngleDeg(0.0), std::nan("")), 0);
  EXPECT_EQ(ViewMemory::sector_of(soccer::AngleDeg(std::nan(""))), 0);
  EXPECT_GT(view.age_around(soccer::AngleDeg(0.0), 30.0), 0);
}

}  // namespace
}  // namespace cls::player
