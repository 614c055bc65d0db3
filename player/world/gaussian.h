// Gaussian estimates and their update by interval observations (quantized values).
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/fixed_list.h"
#include "player/world/truncated_normal.h"

namespace cls::player {

template <std::size_t N>
using VecN = std::array<double, N>;

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

template <std::size_t N>
double dot(const VecN<N>& a, const VecN<N>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// Covariance times h: the covariance of each state component with h . z.
template <std::size_t N>
VecN<N> covariance_with(const Gaussian<N>& estimate, const VecN<N>& h) {
  VecN<N> out{};
  for (std::size_t r = 0; r < N; ++r) {
    for (std::size_t c = 0; c < N; ++c) out[r] += estimate.at(r, c) * h[c];
  }
  return out;
}

/// Rank-one update (as in a Kalman filter): moves h . z, whose covariance with z is `gain`, by
/// `shift` and reduces its variance from `variance` to `variance - reduction`. What is known
/// exactly (variance 0) stays.
template <std::size_t N>
void rank_one_update(Gaussian<N>& estimate, const VecN<N>& gain, double variance, double shift,
                     double reduction) {
  if (variance <= 0.0) return;

  const double step = shift / variance;
  const double shrink = reduction / (variance * variance);

  for (std::size_t r = 0; r < N; ++r) {
    estimate.mean[r] += gain[r] * step;
    for (std::size_t c = 0; c < N; ++c) estimate.at(r, c) -= gain[r] * gain[c] * shrink;
  }
}

/// Posterior mean and variance of the normal h . z given one slab.
inline Moments truncate_noisy(Moments along, double low, double high, double noise_variance) {
  const Moments noisy{along.mean, along.variance + noise_variance};
  const Moments inside = truncated(noisy, low, high);
  const double share = along.variance / noisy.variance;
  return {along.mean + share * (inside.mean - noisy.mean),
          along.variance - share * share * (noisy.variance - inside.variance)};
}

/// Updates the estimate by one slab (moment matching: exact along h).
template <std::size_t N>
void condition(Gaussian<N>& estimate, const Slab<N>& slab) {
  const VecN<N> gain = covariance_with(estimate, slab.direction);
  const double variance = dot(slab.direction, gain);
  if (variance <= 0.0) return;
  const double mean = dot(slab.direction, estimate.mean);
  const Moments after = truncate_noisy({mean, variance}, slab.low, slab.high, slab.noise_variance);
  rank_one_update(estimate, gain, variance, after.mean - mean, variance - after.variance);
}

constexpr std::size_t kMaxSlabs = 160;

/// Updates the estimate by all slabs jointly with expectation propagation: `sweeps` passes in which
/// each slab is approximated by a normal factor, given the others. Accurate to a few percent of the
/// standard deviation where the feasible region has many faces. Ignores slabs beyond kMaxSlabs.
template <std::size_t N>
void condition(Gaussian<N>& estimate, std::span<const Slab<N>> slabs, int sweeps) {
  struct Site {
    double precision = 0.0;
    double shift = 0.0;
  };

  const std::size_t count = std::min(slabs.size(), kMaxSlabs);
  base::FixedList<Site, kMaxSlabs> sites;
  for (std::size_t i = 0; i < count; ++i) sites.push_back({});

  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < count; ++i) {
      const Slab<N>& slab = slabs[i];
      Site& site = sites[i];
      const VecN<N> gain = covariance_with(estimate, slab.direction);
      const double variance = dot(slab.direction, gain);
      if (variance <= 0.0) continue;

      const double mean = dot(slab.direction, estimate.mean);
      // A slab that contains 4 standard deviations carries no information.
      const double reach = 4.0 * std::sqrt(variance + slab.noise_variance);
      if (site.precision == 0.0 && mean - reach > slab.low && mean + reach < slab.high) continue;

      const double cavity_precision = 1.0 / variance - site.precision;
      if (cavity_precision <= 0.0) continue;
      const double cavity_variance = 1.0 / cavity_precision;
      const double cavity_mean = cavity_variance * (mean / variance - site.shift);
      const Moments after =
          truncate_noisy({cavity_mean, cavity_variance}, slab.low, slab.high, slab.noise_variance);
      site.precision = std::max(0.0, 1.0 / after.variance - cavity_precision);
      const double new_precision = cavity_precision + site.precision;
      const double new_mean = after.mean;
      site.shift = new_mean * new_precision - cavity_mean * cavity_precision;
      rank_one_update(estimate, gain, variance, new_mean - mean, variance - 1.0 / new_precision);
    }
  }
}

}  // namespace cls::player
