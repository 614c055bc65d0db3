// Gaussian beliefs, and what observations that only give intervals do to them.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "proxy/world/truncated_normal.h"

namespace cls::proxy {

template <std::size_t N>
using VecN = std::array<double, N>;

/// A normal distribution over N numbers; the covariance row by row.
template <std::size_t N>
struct Gaussian {
  VecN<N> mean{};
  std::array<double, N * N> covariance{};

  double& at(std::size_t row, std::size_t column) { return covariance[row * N + column]; }
  double at(std::size_t row, std::size_t column) const { return covariance[row * N + column]; }
};

/// The observation "low <= h . z + e <= high": z what is believed about, h `direction`, e normal
/// with `noise_variance` (0: none). A printed, quantised value is such an interval.
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

/// Covariance times h: how each number moves with h . z.
template <std::size_t N>
VecN<N> covariance_with(const Gaussian<N>& belief, const VecN<N>& h) {
  VecN<N> out{};
  for (std::size_t r = 0; r < N; ++r) {
    for (std::size_t c = 0; c < N; ++c) out[r] += belief.at(r, c) * h[c];
  }
  return out;
}

/// Changes the belief so that h . z, whose covariance with z is `gain`, moves by `shift` and its
/// variance `variance` becomes `variance - reduction`.
template <std::size_t N>
void regress(Gaussian<N>& belief, const VecN<N>& gain, double variance, double shift,
             double reduction) {
  const double step = shift / variance;
  const double shrink = reduction / (variance * variance);
  for (std::size_t r = 0; r < N; ++r) {
    belief.mean[r] += gain[r] * step;
    for (std::size_t c = 0; c < N; ++c) belief.at(r, c) -= gain[r] * gain[c] * shrink;
  }
}

/// What one slab tells about h . z that is believed to be normal: the new mean and variance.
inline Moments cut(Moments along, double low, double high, double noise_variance) {
  const Moments seen{along.mean, along.variance + noise_variance};
  const Moments kept = truncated(seen, low, high);
  const double share = along.variance / seen.variance;
  return {along.mean + share * (kept.mean - seen.mean),
          along.variance - share * share * (seen.variance - kept.variance)};
}

/// Conditions the belief on one slab (by moments: exact along h).
template <std::size_t N>
void condition(Gaussian<N>& belief, const Slab<N>& slab) {
  const VecN<N> gain = covariance_with(belief, slab.direction);
  const double variance = dot(slab.direction, gain);
  if (variance <= 0.0) return;
  const double mean = dot(slab.direction, belief.mean);
  const Moments after = cut({mean, variance}, slab.low, slab.high, slab.noise_variance);
  regress(belief, gain, variance, after.mean - mean, variance - after.variance);
}

constexpr std::size_t kMaxSlabs = 160;

/// Conditions the belief on all slabs together by expectation propagation: each slab is replaced
/// by the normal factor that acts like it among the others, `sweeps` times round. Good to a few
/// percent of the result's own width where the feasible region is a body of many faces. Slabs
/// beyond kMaxSlabs are left out.
template <std::size_t N>
void condition(Gaussian<N>& belief, std::span<const Slab<N>> slabs, int sweeps) {
  struct Site {
    double precision = 0.0;
    double shift = 0.0;
  };
  std::array<Site, kMaxSlabs> sites{};
  const std::size_t count = std::min(slabs.size(), kMaxSlabs);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < count; ++i) {
      const Slab<N>& slab = slabs[i];
      Site& site = sites[i];
      const VecN<N> gain = covariance_with(belief, slab.direction);
      const double variance = dot(slab.direction, gain);
      if (variance <= 0.0) continue;
      const double mean = dot(slab.direction, belief.mean);
      // A slab that the belief does not touch tells nothing.
      const double reach = 4.0 * std::sqrt(variance + slab.noise_variance);
      if (site.precision == 0.0 && mean - reach > slab.low && mean + reach < slab.high) continue;

      const double cavity_precision = 1.0 / variance - site.precision;
      if (cavity_precision <= 0.0) continue;
      const double cavity_variance = 1.0 / cavity_precision;
      const double cavity_mean = cavity_variance * (mean / variance - site.shift);
      const Moments after =
          cut({cavity_mean, cavity_variance}, slab.low, slab.high, slab.noise_variance);
      site.precision = std::max(0.0, 1.0 / after.variance - cavity_precision);
      const double new_precision = cavity_precision + site.precision;
      const double new_mean = after.mean;
      site.shift = new_mean * new_precision - cavity_mean * cavity_precision;
      regress(belief, gain, variance, new_mean - mean, variance - 1.0 / new_precision);
    }
  }
}

}  // namespace cls::proxy
