// Numbers of about 106 bits as an unevaluated sum of two doubles, for portable_math.cpp.
//
// The order of operations is part of the contract: it is the order of SLEEF 3.5.1, so that results
// have the same bits (tests/soccer/portable_math_test.cpp). No fused multiply-add: builds have
// -ffp-contract=off.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace cls::soccer::math::portable {

/// high + low, where low is at most half a unit in the last place of high, or a little more.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  DoubleDouble operator-() const { return {-high, -low}; }
  /// By a power of two.
  DoubleDouble scaled(double factor) const { return {high * factor, low * factor}; }
  DoubleDouble normalized() const {
    const double total = high + low;
    return {total, high - total + low};
  }
  double rounded() const { return high + low; }
};

/// The upper 26 bits of the significand: products of two such halves are exact.
inline double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xffff'ffff'f800'0000u);
}

struct Halves {
  explicit Halves(double x) : upper(upper_half(x)), lower(x - upper) {}
  double upper;
  double lower;
};

// Sums; the first argument has the greater magnitude.

inline DoubleDouble ordered_sum(double x, double y) {
  const double total = x + y;
  return {total, x - total + y};
}
inline DoubleDouble ordered_sum(DoubleDouble x, double y) {
  const double total = x.high + y;
  return {total, x.high - total + y + x.low};
}
inline DoubleDouble ordered_sum(double x, DoubleDouble y) {
  const double total = x + y.high;
  return {total, x - total + y.high + y.low};
}
inline DoubleDouble ordered_sum(DoubleDouble x, DoubleDouble y) {
  const double total = x.high + y.high;
  return {total, x.high - total + y.high + x.low + y.low};
}
inline DoubleDouble ordered_difference(DoubleDouble x, double y) {
  const double difference = x.high - y;
  return {difference, x.high - difference - y + x.low};
}
inline DoubleDouble ordered_difference(DoubleDouble x, DoubleDouble y) {
  const double difference = x.high - y.high;
  return {difference, x.high - difference - y.high + x.low - y.low};
}

// Sums of arguments of any magnitude.

inline DoubleDouble sum(double x, double y) {
  const double total = x + y;
  const double y_part = total - x;
  return {total, (x - (total - y_part)) + (y - y_part)};
}
inline DoubleDouble sum(DoubleDouble x, double y) {
  const DoubleDouble high = sum(x.high, y);
  return {high.high, high.low + x.low};
}
inline DoubleDouble sum(double x, DoubleDouble y) {
  const DoubleDouble high = sum(x, y.high);
  return {high.high, high.low + y.low};
}
inline DoubleDouble sum(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble high = sum(x.high, y.high);
  return {high.high, high.low + (x.low + y.low)};
}

// Products.

inline DoubleDouble product(double x, double y) {
  const Halves a(x);
  const Halves b(y);
  const double rounded = x * y;
  return {rounded,
          a.upper * b.upper - rounded + a.lower * b.upper + a.upper * b.lower + a.lower * b.lower};
}
inline DoubleDouble product(DoubleDouble x, double y) {
  const DoubleDouble high = product(x.high, y);
  return {high.high, high.low + x.low * y};
}
inline DoubleDouble product(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble high = product(x.high, y.high);
  return {high.high, high.low + x.high * y.low + x.low * y.high};
}
inline double rounded_product(DoubleDouble x, DoubleDouble y) {
  const Halves a(x.high);
  const Halves b(y.high);
  return x.low * b.upper + a.upper * y.low + a.lower * b.lower + a.upper * b.lower +
         a.lower * b.upper + a.upper * b.upper;
}

inline DoubleDouble square(DoubleDouble x) {
  const Halves a(x.high);
  const double rounded = x.high * x.high;
  return {rounded, a.upper * a.upper - rounded + (a.upper + a.upper) * a.lower + a.lower * a.lower +
                       x.high * (x.low + x.low)};
}
inline double rounded_square(DoubleDouble x) {
  const Halves a(x.high);
  return a.upper * x.low + a.upper * x.low + a.lower * a.lower +
         (a.upper * a.lower + a.upper * a.lower) + a.upper * a.upper;
}

// Quotients.

/// 1 - a * b, where b is nearly 1 / a.
inline double reciprocal_error(const Halves& a, const Halves& b) {
  return 1.0 - a.upper * b.upper - a.upper * b.lower - a.lower * b.upper - a.lower * b.lower;
}
inline DoubleDouble reciprocal(double x) {
  const double rounded = 1.0 / x;
  return {rounded, rounded * reciprocal_error(Halves(x), Halves(rounded))};
}
inline DoubleDouble quotient(DoubleDouble x, DoubleDouble y) {
  const double inverse = 1.0 / y.high;
  const Halves a(x.high);
  const Halves b(inverse);
  const double rounded = x.high * inverse;

  const double error = a.upper * b.upper - rounded + a.upper * b.lower + a.lower * b.upper +
                       a.lower * b.lower + rounded * reciprocal_error(Halves(y.high), b);
  return {rounded, inverse * (x.low - rounded * y.low) + error};
}

inline DoubleDouble square_root(double x) {
  const double rounded = std::sqrt(x);
  return product(sum(x, product(rounded, rounded)), reciprocal(rounded)).scaled(0.5);
}

}  // namespace cls::soccer::math::portable
