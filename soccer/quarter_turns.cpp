// Payne and Hanek's reduction with four doubles of 1 / (2 pi), as SLEEF 3.5.1 has them in a table.
#include "soccer/quarter_turns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cls::soccer::math::portable {
namespace {

// The binary digits of 1 / (2 pi) after the point.
constexpr std::array<std::uint64_t, 21> kDigits = {
    0x28be60db9391054a, 0x7f09d5f47d4d3770, 0x36d8a5664f10e410, 0x7f9458eaf7aef158,
    0x6dc91b8e909374b8, 0x01924bba82746487, 0x3f877ac72c4a69cf, 0xba208d7d4baed121,
    0x3a671c09ad17df90, 0x4e64758e60d4ce7d, 0x272117e2ef7e4a0e, 0xc7fe25fff7816603,
    0xfbcbc462d6829b47, 0xdb4d9fb3c9f2c26d, 0xd3d18fd9a797fa8b, 0x5d49eeb1faf97c5e,
    0xcf41ce7de294a4ba, 0x9afed7ec47e35742, 0x1580cc11bf1edaea, 0xfc33ef0826bd0d87,
    0x6a78e45857b986c2};

/// 384 bits in two's complement, least significant word first.
using Wide = std::array<std::uint64_t, 6>;
constexpr int kWordBits = 64;
constexpr int kFractionBits = 320;  ///< digits in a Wide; the word above them has the sign

bool is_negative(const Wide& wide) { return wide.back() >> (kWordBits - 1) != 0; }

Wide negated(Wide wide) {
  bool carry = true;
  for (std::uint64_t& word : wide) {
    word = ~word + (carry ? 1 : 0);
    carry = carry && word == 0;
  }
  return wide;
}

bool bit(const Wide& wide, int position) {
  return position >= 0 &&
         (wide[static_cast<std::size_t>(position / kWordBits)] >> (position % kWordBits) & 1) != 0;
}

int top_bit(const Wide& wide) {
  int position = static_cast<int>(wide.size()) * kWordBits - 1;
  while (position >= 0 && !bit(wide, position)) --position;
  return position;
}

bool any_bit_below(const Wide& wide, int end) {
  for (int position = 0; position < end; ++position) {
    if (bit(wide, position)) return true;
  }
  return false;
}

// wide -= value * 2^shift, for shift >= 0.
void subtract(Wide& wide, std::uint64_t value, int shift) {
  const auto first = static_cast<std::size_t>(shift / kWordBits);
  const int within = shift % kWordBits;
  const std::array<std::uint64_t, 2> parts = {value << within,
                                              within == 0 ? 0 : value >> (kWordBits - within)};
  std::uint64_t borrow = 0;
  for (std::size_t i = first; i < wide.size(); ++i) {
    const std::uint64_t part = i - first < parts.size() ? parts[i - first] : 0;
    const std::uint64_t before = wide[i];
    wide[i] = before - part - borrow;
    borrow = before < part || (before == part && borrow != 0) ? 1 : 0;
  }
}

// The nearest double, its last bit cleared if `even`, in units of 2^-kFractionBits; takes it from
// `wide`.
double take_double(Wide& wide, bool even) {
  constexpr int kSignificand = 53;
  const bool negative = is_negative(wide);
  if (negative) wide = negated(wide);
  const int top = top_bit(wide);
  if (top < 0) return 0.0;

  const int lowest = std::max(0, top - (kSignificand - 1));
  std::uint64_t significand = 0;
  for (int position = top; position >= lowest; --position) {
    significand = significand << 1 | (bit(wide, position) ? 1 : 0);
  }
  const bool half = bit(wide, lowest - 1);
  if (half && ((significand & 1) != 0 || any_bit_below(wide, lowest - 1))) ++significand;
  if (even) significand &= ~std::uint64_t{1};

  subtract(wide, significand, lowest);
  if (negative) wide = negated(wide);
  const double magnitude = std::ldexp(static_cast<double>(significand), lowest - kFractionBits);
  return negative ? -magnitude : magnitude;
}

// 2^scale / (2 pi) without the digits whose product with a number of this exponent is whole.
std::array<double, 4> inverse_turn(int exponent, int scale) {
  constexpr int kFirstExponent = 55;
  const int skipped = std::max(exponent, kFirstExponent) - 53;
  Wide wide = {};
  for (int position = 0; position < kFractionBits; ++position) {
    const int digit = skipped + position;
    const std::uint64_t word = kDigits[static_cast<std::size_t>(digit / kWordBits)];
    const std::uint64_t value = word >> (kWordBits - 1 - digit % kWordBits) & 1;
    const int place = kFractionBits - 1 - position;
    wide[static_cast<std::size_t>(place / kWordBits)] |= value << (place % kWordBits);
  }

  std::array<double, 4> parts = {};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = std::ldexp(take_double(wide, i + 1 < parts.size()), scale - skipped);
  }
  return parts;
}

// Removes whole quarters from a number of turns and returns how many, modulo 4.
std::int32_t take_quarters(double& turns) {
  const double magic = std::copysign(0x1p52, turns);
  const auto nearest = [&](double x) {
    return std::fabs(x) > 0x1p52 ? x : std::copysign(x + magic - magic, turns);
  };
  const double quarters = nearest(4.0 * turns);
  const double whole = nearest(turns);
  turns = -0.25 * quarters + turns;
  return static_cast<std::int32_t>(-4.0 * whole + quarters);
}

}  // namespace

QuarterTurns quarter_turns_of_large(double radians) {
  // Without a scale the parts for large exponents would be too small for products of their halves.
  const int exponent = std::ilogb(radians);
  const int scale = exponent > 700 ? 64 : 0;
  const std::array<double, 4> parts = inverse_turn(exponent, scale);
  radians = std::ldexp(radians, -scale);

  QuarterTurns turns;
  DoubleDouble x = product(radians, parts[0]);
  turns.count = take_quarters(x.high);
  x = sum(x.normalized(), product(radians, parts[1]));
  turns.count += take_quarters(x.high);
  x = sum(x.normalized(), product(DoubleDouble{parts[2], parts[3]}, radians)).normalized();
  turns.rest = product(x, DoubleDouble{3.141592653589793116 * 2, 1.2246467991473532072e-16 * 2});
  return turns;
}

}  // namespace cls::soccer::math::portable
