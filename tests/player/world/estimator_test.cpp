// Numerical tools of the estimators: truncated normals, distance quantization, assignment, Gaussian
// updates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "player/looking/neck_search.h"
#include "player/tracking/assignment.h"
#include "player/tracking/observed_object.h"
#include "player/world/gaussian.h"
#include "player/world/seen_distance.h"
#include "player/world/view_cone.h"
#include "soccer/random.h"

namespace cls::player {
namespace {

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
    const Vec2 eye{random.uniform(-50.0, 50.0), random.uniform(-30.0, 30.0)};
    const Vec2 direction = soccer::polar_degrees(1.0, random.uniform(-180.0, 180.0));
    const double d = random.uniform(1.0, 50.0);
    // Near the object, or anywhere.
    const bool near = i % 2 == 0;
    const Vec2 off = soccer::polar_degrees(random.uniform(0.0, near ? 2.0 : 40.0),
                                           random.uniform(-180.0, 180.0));
    const Vec2 focus = (near ? eye + direction * d : eye) + off;
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
    } while (std::ranges::next_permutation(order).found);
    EXPECT_DOUBLE_EQ(total, least);
  }
}

TEST(Gaussian, ConvergesToCenterOfFeasibleRegion) {
  // The triangle x >= 0, y >= 0, x + y <= 1 with a flat prior: its center is at one third.
  Gaussian<2> estimate;
  estimate.at(0, 0) = estimate.at(1, 1) = 100.0;
  const std::array<Slab<2>, 3> slabs = {
      {{{1.0, 0.0}, 0.0, 50.0, 0.0}, {{0.0, 1.0}, 0.0, 50.0, 0.0}, {{1.0, 1.0}, -50.0, 1.0, 0.0}}};
  condition(estimate, std::span<const Slab<2>>(slabs), 10);
  EXPECT_NEAR(estimate.mean[0], 1.0 / 3.0, 0.03);
  EXPECT_NEAR(estimate.mean[1], 1.0 / 3.0, 0.03);
  EXPECT_NEAR(estimate.at(0, 0), 1.0 / 18.0, 0.015);
  EXPECT_NEAR(estimate.at(0, 1), -1.0 / 36.0, 0.01);
}

/// Expectation propagation without shortcuts: every site again in each sweep.
template <std::size_t N>
void plain_condition(Gaussian<N>& estimate, const std::vector<Slab<N>>& slabs, int sweeps) {
  std::vector<Site> sites(slabs.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      const Slab<N>& slab = slabs[i];
      const VecN<N> gain = covariance_with(estimate, slab.direction);
      const double variance = dot(slab.direction, gain);
      const double mean = dot(slab.direction, estimate.mean);
      const double rest = 1.0 / variance - sites[i].precision;
      if (rest <= 0.0) continue;

      const double rest_mean = (mean / variance - sites[i].shift) / rest;
      const Moments after =
          truncate_noisy({rest_mean, 1.0 / rest}, slab.low, slab.high, slab.noise_variance);
      sites[i].precision = std::max(0.0, 1.0 / after.variance - rest);
      const double precision = rest + sites[i].precision;
      sites[i].shift = after.mean * precision - rest_mean * rest;
      rank_one_update(estimate, gain, variance, after.mean - mean, variance - 1.0 / precision);
    }
  }
}

/// Largest difference of two estimates, in standard deviations and shares of the variances.
template <std::size_t N>
double difference(const Gaussian<N>& a, const Gaussian<N>& b) {
  double most = 0.0;
  for (std::size_t r = 0; r < N; ++r) {
    most = std::max(most, std::fabs(a.mean[r] - b.mean[r]) / std::sqrt(b.at(r, r)));
    for (std::size_t c = 0; c < N; ++c) {
      const double scale = std::sqrt(b.at(r, r) * b.at(c, c));
      most = std::max(most, std::fabs(a.at(r, c) - b.at(r, c)) / scale);
    }
  }
  return most;
}

/// Directions and distances of landmarks, as intervals around those from a pose drawn from `prior`.
std::vector<Slab<3>> random_landmarks(const Gaussian<3>& prior, soccer::RandomStream& random) {
  VecN<3> pose{};
  for (std::size_t i = 0; i < 3; ++i) pose[i] = random.normal(0.0, std::sqrt(prior.at(i, i)));

  std::vector<Slab<3>> slabs;
  const int landmarks = 1 + random.integer(30);
  for (int i = 0; i < landmarks; ++i) {
    const double distance = random.uniform(2.0, 90.0);
    const Vec2 e = soccer::polar_degrees(1.0, random.uniform(-180.0, 180.0));
    const double per_meter = math::to_degrees(1.0) / distance;
    for (const auto& [direction, half] :
         {std::pair{VecN<3>{e.y * per_meter, -e.x * per_meter, -1.0}, 0.5},
          std::pair{VecN<3>{-e.x, -e.y, 0.0}, 0.05 + 0.005 * distance}}) {
      const double middle = dot(direction, pose) + random.uniform(-half, half);
      slabs.push_back({direction, middle - half, middle + half, 0.0});
    }
  }
  return slabs;
}

/// The intervals of an observed object as slabs with directions on the pitch.
std::vector<Slab<4>> pitch_slabs(const Viewpoint& view, const ObservedPosition& observed,
                                 const soccer::Observation& seen) {
  const Vec2 e = observed.direction;
  const Vec2 n{-e.y, e.x};
  const double d = observed.distance;
  const double half = math::to_radians(0.5);
  const double turned = math::to_radians(1.0) * d;
  const double along = soccer::dot(e, view.position);
  const double across = soccer::dot(n, view.position);
  std::vector<Slab<4>> slabs = {{{e.x, e.y, 0.0, 0.0},
                                 along + observed.range.low,
                                 along + observed.range.high,
                                 view.position_variance},
                                {{n.x, n.y, 0.0, 0.0},
                                 across - half * d,
                                 across + half * d,
                                 view.position_variance + turned * turned * view.face_variance}};
  if (seen.detail < soccer::ObservedDetail::kMotion) return slabs;

  const double ratio = math::quantize(seen.distance_change / seen.distance, 0.02);
  const double turning = math::to_radians(seen.direction_change);
  const double radial = soccer::dot(e, view.velocity) + ratio * d;
  const double sideways = soccer::dot(n, view.velocity) + turning * d;
  slabs.push_back({{0.0, 0.0, e.x, e.y},
                   radial - 0.01 * d,
                   radial + 0.01 * d,
                   observed.along_variance * ratio * ratio});
  slabs.push_back({{0.0, 0.0, n.x, n.y},
                   sideways - 0.1 * half * d,
                   sideways + 0.1 * half * d,
                   observed.along_variance * turning * turning});
  return slabs;
}

TEST(Gaussian, ShortcutsChangeEstimateLittle) {
  soccer::RandomStream random(12, "landmarks");
  double sum = 0.0;
  double most = 0.0;
  constexpr int kTries = 3000;
  for (int i = 0; i < kTries; ++i) {
    Gaussian<3> fast;
    fast.at(0, 0) = fast.at(1, 1) = math::exp(random.uniform(-9.0, 0.0));
    fast.at(2, 2) = math::exp(random.uniform(-5.0, 3.0));
    Gaussian<3> plain = fast;
    const std::vector<Slab<3>> slabs = random_landmarks(fast, random);
    condition(fast, std::span<const Slab<3>>(slabs), 4);
    plain_condition(plain, slabs, 4);
    sum += difference(fast, plain);
    most = std::max(most, difference(fast, plain));
  }
  EXPECT_LT(sum / kTries, 0.002);
  EXPECT_LT(most, 0.15);
}

TEST(ObservedObject, UpdatesInItsFrameAsInTheFrameOfThePitch) {
  soccer::RandomStream random(13, "objects");
  double most = 0.0;
  for (int i = 0; i < 3000; ++i) {
    Viewpoint view;
    view.position = {random.uniform(-50.0, 50.0), random.uniform(-30.0, 30.0)};
    view.velocity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    view.face = random.uniform(-180.0, 180.0);
    view.position_variance = math::exp(random.uniform(-9.0, -3.0));
    view.face_variance = math::exp(random.uniform(-6.0, 0.0));
    soccer::Observation seen;
    seen.detail = i % 2 == 0 ? soccer::ObservedDetail::kPosition : soccer::ObservedDetail::kMotion;
    seen.distance = math::quantize(random.uniform(1.0, 60.0), 0.1);
    seen.direction = std::rint(random.uniform(-45.0, 45.0));
    seen.distance_change = 0.02 * seen.distance * std::rint(random.uniform(-3.0, 3.0));
    seen.direction_change = 0.1 * std::rint(random.uniform(-10.0, 10.0));
    const ObservedPosition observed = observed_position(view, DistanceTable(0.1), seen);

    // Somewhere near, with correlated components.
    ObjectEstimate fast = initial_estimate(view, observed, seen, {0.3, -0.2}, 0.1);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      fast.mean[axis] += random.normal(0.0, std::sqrt(fast.at(axis, axis)));
      fast.at(axis, axis) += 0.04;
      fast.at(axis, axis + 2) += 0.03;
      fast.at(axis + 2, axis) += 0.03;
      fast.at(axis + 2, axis + 2) += 0.04;
    }
    ObjectEstimate plain = fast;
    update_estimate(fast, view, observed, seen);
    plain_condition(plain, pitch_slabs(view, observed, seen), 3);
    most = std::max(most, difference(fast, plain));
  }

  EXPECT_LT(most, 0.01);
}

TEST(Gaussian, NoiseWeakensSlab) {
  Gaussian<1> sharp;
  sharp.at(0, 0) = 1.0;
  Gaussian<1> soft = sharp;
  condition(sharp, Slab<1>{{1.0}, 1.0, 1.2, 0.0});
  condition(soft, Slab<1>{{1.0}, 1.0, 1.2, 1.0});
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

TEST(VisibleArea, IsTheViewConeLessTheMargin) {
  soccer::RandomStream random(14, "cone");
  int visible = 0;
  WorldModel world;

  for (int i = 0; i < 20000; ++i) {
    world.self.position = {random.uniform(-50.0, 50.0), random.uniform(-30.0, 30.0)};
    world.self.body = AngleDeg(random.uniform(-180.0, 180.0));
    world.self.neck = AngleDeg(random.uniform(-90.0, 90.0));
    world.self.view_width = static_cast<soccer::ViewWidth>(random.integer(3));
    const Vec2 offset =
        soccer::polar_degrees(random.uniform(0.0, 60.0), random.uniform(-180.0, 180.0));
    const double deviation = random.uniform(0.0, 2.0);

    const double distance = offset.length();
    const double blur = 2.5 * deviation;
    bool expected = distance + blur < world.server().visible_distance - 0.1;
    if (!expected && distance > blur) {
      const double angle = (AngleDeg::of(offset) - world.self.face()).abs();
      const double margin = math::to_degrees(math::asin(blur / distance)) + 1.0;
      expected = angle + margin < view_angle(world.server(), world.self.view_width) / 2.0;
    }
    EXPECT_EQ(VisibleArea(world).must_show(world.self.position + offset, deviation), expected) << i;
    visible += expected ? 1 : 0;
  }
  EXPECT_GT(visible, 2000);
}

TEST(ViewMemory, DirectionThatIsNotANumberHasNoSectors) {
  ViewMemory view;
  for (int& age : view.ages) age = 3;
  EXPECT_EQ(view.age_around(AngleDeg(std::nan("")), 30.0), 0);
  EXPECT_EQ(view.age_around(AngleDeg(0.0), std::nan("")), 0);
  EXPECT_EQ(ViewMemory::sector_of(AngleDeg(std::nan(""))), 0);
  EXPECT_GT(view.age_around(AngleDeg(0.0), 30.0), 0);
}

TEST(ViewMemory, SumsOfSectorsAreThoseOfAges) {
  soccer::RandomStream random(3, "ages");
  ViewMemory view;
  for (int& age : view.ages) age = random.integer(1000);
  const SectorSums sums = sector_sums(view.ages);

  for (int i = 0; i < 2000; ++i) {
    const AngleDeg direction(random.uniform(-180.0, 180.0));
    const double half = random.uniform(0.0, 200.0);
    ASSERT_EQ(sum_of(sums, sectors_around(direction, half)), view.age_around(direction, half))
        << direction.degrees() << ' ' << half;
  }
}

}  // namespace
}  // namespace cls::player
