// Gaussian estimates and their update by interval observations (quantized values).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/fixed_list.h"

namespace cls::player {

struct Moments {
  double mean = 0.0;
  double variance = 1.0;
};

/// Moments of a normal distribution (variance > 0) truncated to [low, high] (low < high). Accurate
/// to about 1e-4 standard deviations in the bulk, and a few percent of the result's deviation far
/// in a tail. The mean is inside the interval, the variance not above the input. Same bits on every
/// platform.
Moments truncated(Moments normal, double low, double high);

template <std::size_t N>
using VecN = std::array<double, N>;

constexpr double square(double x) { return x * x; }

/// Standard deviation per axis of a vector of uniform length up to 1 and uniform direction, as the
/// noise of moving objects: 1 / sqrt 6.
constexpr double kDiscDeviation = 0.408248290463863;

/// Multivariate normal distribution; covariance in row-major order.
template <std::size_t N>
struct Gaussian {
  VecN<N> mean{};
  std::array<double, N * N> covariance{};

  double& at(std::size_t row, std::size_t column) { return covariance[row * N + column]; }
  double at(std::size_t row, std::size_t column) const { return covariance[row * N + column]; }
};

/// Interval observation "low <= h . z + e <= high": z the estimated state, h `direction`, e normal
/// noise with `noise_variance` (0: none). A quantized value in a message is such an interval.
template <std::size_t N>
struct Slab {
  VecN<N> direction{};
  double low = 0.0;
  double high = 0.0;
  double noise_variance = 0.0;
};

/// A slab whose h is the unit vector of one component of the state.
struct AxisSlab {
  std::size_t axis = 0;
  double low = 0.0;
  double high = 0.0;
  double noise_variance = 0.0;
};

/// Calls `f` with 0 to N - 1 without a loop, which would cost as much as the few operations in it.
template <std::size_t N, typename F>
[[gnu::always_inline]] inline void for_each_index(F f) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) { (f(kIndex), ...); }
  (std::make_index_sequence<N>{});
}

template <std::size_t N>
[[gnu::always_inline]] inline double dot(const VecN<N>& a, const VecN<N>& b) {
  double sum = 0.0;
  for_each_index<N>([&](std::size_t i) { sum += a[i] * b[i]; });
  return sum;
}

/// Covariance times h: the covariance of each state component with h . z.
template <std::size_t N>
VecN<N> covariance_with(const Gaussian<N>& estimate, const VecN<N>& h) {
  VecN<N> out{};
  for_each_index<N>([&](std::size_t r) {
    for_each_index<N>([&](std::size_t c) { out[r] += estimate.at(r, c) * h[c]; });
  });
  return out;
}

/// h . v of a slab.
template <std::size_t N>
double along(const Slab<N>& slab, const VecN<N>& v) {
  return dot(slab.direction, v);
}
template <std::size_t N>
double along(const AxisSlab& slab, const VecN<N>& v) {
  return v[slab.axis];
}

/// Covariance of each state component with h . z of a slab.
template <std::size_t N>
VecN<N> gain_of(const Gaussian<N>& estimate, const Slab<N>& slab) {
  return covariance_with(estimate, slab.direction);
}
template <std::size_t N>
VecN<N> gain_of(const Gaussian<N>& estimate, const AxisSlab& slab) {
  VecN<N> out{};
  for (std::size_t r = 0; r < N; ++r) out[r] = estimate.at(r, slab.axis);
  return out;
}

/// Rank-one update (as in a Kalman filter): moves h . z, whose covariance with z is `gain`, by
/// `shift` and reduces its variance from `variance` to `variance - reduction`. What is known
/// exactly (variance 0) stays.
template <std::size_t N>
void rank_one_update(Gaussian<N>& estimate, const VecN<N>& gain, double variance, double shift,
                     double reduction) {
  if (variance <= 0.0) return;

  const double inverse = 1.0 / variance;
  const double step = shift * inverse;
  const double shrink = reduction * inverse * inverse;

  for_each_index<N>([&](std::size_t r) {
    estimate.mean[r] += gain[r] * step;
    const double row = gain[r];
    for_each_index<N>([&](std::size_t c) { estimate.at(r, c) -= row * gain[c] * shrink; });
  });
}

/// Posterior mean and variance of the normal h . z given one slab.
inline Moments truncate_noisy(Moments prior, double low, double high, double noise_variance) {
  if (noise_variance == 0.0) return truncated(prior, low, high);
  const Moments noisy{prior.mean, prior.variance + noise_variance};
  const Moments inside = truncated(noisy, low, high);
  const double share = prior.variance / noisy.variance;
  return {prior.mean + share * (inside.mean - noisy.mean),
          prior.variance - share * share * (noisy.variance - inside.variance)};
}

/// Normal factor that stands for a slab in expectation propagation.
struct Site {
  double precision = 0.0;
  double shift = 0.0;          ///< precision times mean
  Moments settled{0.0, -1.0};  ///< h . z just after the last update of this site; none yet

  /// Whether an update would change little: h . z is where the last one left it.
  bool is_settled(Moments now) const {
    constexpr double kTolerance = 0.005;  // standard deviations, and share of the variance
    const double moved = now.mean - settled.mean;
    return moved * moved <= kTolerance * kTolerance * now.variance &&
           std::fabs(now.variance - settled.variance) <= kTolerance * now.variance;
  }
};

/// Whether an interval contains 4 standard deviations of h . z: it carries no information.
inline bool contains_all_of(Moments now, double low, double high, double noise_variance) {
  constexpr double kReach = 4.0;
  const double room = std::min(now.mean - low, high - now.mean);
  return room > 0.0 && room * room > kReach * kReach * (now.variance + noise_variance);
}

/// Computes a site again from `now`, h . z given all sites, and returns h . z with the new one.
template <typename AnySlab>
Moments renew(Site& site, Moments now, const AnySlab& slab) {
  // The other sites alone: what `now` is without this one.
  const double share = 1.0 - now.variance * site.precision;
  if (share <= 0.0) return now;
  const Moments others{(now.mean - now.variance * site.shift) / share, now.variance / share};
  const double others_precision = share / now.variance;

  const Moments after = truncate_noisy(others, slab.low, slab.high, slab.noise_variance);
  const double precision = std::max(1.0 / after.variance, others_precision);
  site.precision = precision - others_precision;
  site.shift = after.mean * precision - others.mean * others_precision;
  site.settled = {after.mean, std::min(after.variance, others.variance)};
  return site.settled;
}

/// Updates the estimate by one slab (moment matching: exact along h).
template <std::size_t N, typename AnySlab>
void condition(Gaussian<N>& estimate, const AnySlab& slab) {
  const VecN<N> gain = gain_of(estimate, slab);
  const Moments now{along(slab, estimate.mean), along(slab, gain)};
  if (now.variance <= 0.0) return;
  const Moments after = truncate_noisy(now, slab.low, slab.high, slab.noise_variance);
  rank_one_update(estimate, gain, now.variance, after.mean - now.mean,
                  now.variance - after.variance);
}

constexpr std::size_t kMaxSlabs = 160;

/// Updates the estimate by all slabs jointly with expectation propagation: up to `sweeps` passes in
/// which each slab is approximated by a normal factor, given the others. Accurate to a few percent
/// of the standard deviation where the feasible region has many faces. Ignores slabs beyond
/// kMaxSlabs. A factor that is settled stays; after two passes those without information are left
/// out.
template <std::size_t N, typename AnySlab>
void condition(Gaussian<N>& estimate, std::span<const AnySlab> slabs, int sweeps) {
  base::FixedList<Site, kMaxSlabs> sites;
  base::FixedList<std::size_t, kMaxSlabs> open;  // slabs that may still change the estimate
  for (std::size_t i = 0; i < std::min(slabs.size(), kMaxSlabs); ++i) {
    sites.push_back({});
    open.push_back(i);
  }

  bool changed = true;
  for (int sweep = 0; sweep < sweeps && changed; ++sweep) {
    changed = false;
    base::FixedList<std::size_t, kMaxSlabs> informative;
    for (const std::size_t i : open) {
      const AnySlab& slab = slabs[i];
      Site& site = sites[i];

      const VecN<N> gain = gain_of(estimate, slab);
      const Moments now{along(slab, estimate.mean), along(slab, gain)};
      if (now.variance <= 0.0) continue;
      if (site.precision == 0.0 && contains_all_of(now, slab.low, slab.high, slab.noise_variance)) {
        continue;
      }
      informative.push_back(i);
      if (site.is_settled(now)) continue;

      const Moments after = renew(site, now, slab);
      rank_one_update(estimate, gain, now.variance, after.mean - now.mean,
                      now.variance - after.variance);
      changed = true;
    }

    // The first estimate may have been off: all slabs are tested a second time.
    if (sweep > 0) open = informative;
  }
}

}  // namespace cls::player
