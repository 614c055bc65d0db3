// Number formatting and parsing. Hand-written, because observations and logs are parsed and written
// in the hot path; the fast paths give the same digits as the standard library (tests).
#include "base/text/number_text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/text/rounded_number.h"

namespace cls::base {
namespace {

constexpr int kSignificantDigits = 6;

// All exact in a double.
constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Decimal exponent of a magnitude in [1e-4, 1e6).
int decimal_exponent(double magnitude) {
  if (magnitude >= 1.0) {
    int exponent = 0;
    while (magnitude >= kPowersOfTen[static_cast<std::size_t>(exponent) + 1]) ++exponent;
    return exponent;
  }

  if (magnitude >= 1e-1) return -1;
  if (magnitude >= 1e-2) return -2;
  if (magnitude >= 1e-3) return -3;
  return -4;
}

// Writes six `digits`, the first of which has the weight 10^exponent, without trailing zeros.
char* write_fixed(char* to, unsigned digits, int exponent) {
  int count = kSignificantDigits;
  while (digits % 10 == 0 && count > 1) {
    digits /= 10;
    --count;
  }

  std::array<char, kSignificantDigits> text;
  for (int i = count - 1; i >= 0; --i) {
    text[static_cast<std::size_t>(i)] = static_cast<char>('0' + digits % 10);
    digits /= 10;
  }

  int next = 0;
  if (exponent < 0) {
    *to++ = '0';
    *to++ = '.';
    for (int i = -1; i > exponent; --i) *to++ = '0';
  } else {
    for (; next <= exponent; ++next) {
      *to++ = next < count ? text[static_cast<std::size_t>(next)] : '0';
    }
    if (next >= count) return to;
    *to++ = '.';
  }

  for (; next < count; ++next) *to++ = text[static_cast<std::size_t>(next)];
  return to;
}

// 00 to 99.
constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

char* write_digit(char* to, unsigned value) {
  *to = static_cast<char>('0' + value);
  return to + 1;
}

// `value` is below 100.
char* write_pair(char* to, unsigned value) {
  to[0] = kPairs[2 * value];
  to[1] = kPairs[2 * value + 1];
  return to + 2;
}

// `value` is below 1000.
char* write_short(char* to, unsigned value) {
  if (value < 10) return write_digit(to, value);
  if (value < 100) return write_pair(to, value);
  return write_pair(write_digit(to, value / 100), value % 100);
}

// Two decimals, without a trailing zero.
char* write_decimals(char* to, unsigned hundredths) {
  if (hundredths % 10 == 0) return write_digit(to, hundredths / 10);
  return write_pair(to, hundredths);
}

constexpr double kTenThousandths = 1e4;

// Most numbers of the protocol are rounded to few decimals: the multiple of 0.0001, which has at
// most six digits, of a magnitude below 100 within 1e-11 of it. Nothing for other magnitudes.
std::optional<unsigned> ten_thousandths(double magnitude) {
  if (!(magnitude < 99.5)) return std::nullopt;

  const double scaled = magnitude * kTenThousandths;
  const auto whole = static_cast<unsigned>(scaled + 0.5);
  if (std::fabs(scaled - whole) > 1e-7 || (whole == 0 && magnitude != 0.0)) return std::nullopt;
  return whole;
}

// Null where ten_thousandths() gives nothing.
char* write_round(char* to, double value) {
  const std::optional<unsigned> whole = ten_thousandths(std::fabs(value));
  if (!whole) return nullptr;

  if (std::signbit(value)) *to++ = '-';
  const unsigned before = *whole / 10000;
  const unsigned after = *whole % 10000;
  to = write_short(to, before);
  if (after == 0) return to;

  *to++ = '.';
  if (after % 100 == 0) return write_decimals(to, after / 100);
  return write_decimals(write_pair(to, after / 100), after % 100);
}

// Six digits, the first of which has the weight 10^exponent.
struct SixDigits {
  unsigned digits = 0;
  int exponent = 0;
};

// The digits of fixed notation, for magnitudes that are not close to the tie between two roundings,
// where the error of one multiplication (about 1e-10 of a unit in the sixth digit) could matter.
// Nothing for others.
std::optional<SixDigits> six_digits(double magnitude) {
  if (!(magnitude >= 1e-4 && magnitude < 999999.0)) return std::nullopt;

  int exponent = decimal_exponent(magnitude);
  const double scaled =
      magnitude * kPowersOfTen[static_cast<std::size_t>(kSignificantDigits - 1 - exponent)];
  const auto below = static_cast<unsigned>(scaled);
  const double rest = scaled - below;
  if (std::fabs(rest - 0.5) < 1e-6) return std::nullopt;

  unsigned digits = below + (rest > 0.5 ? 1 : 0);
  if (digits < 100000) return std::nullopt;
  if (digits == 1000000) {
    digits = 100000;
    ++exponent;
  }
  return SixDigits{digits, exponent};
}

// Null where six_digits() gives nothing.
char* write_common(char* to, double value) {
  const std::optional<SixDigits> number = six_digits(std::fabs(value));
  if (!number) return nullptr;
  if (std::signbit(value)) *to++ = '-';
  return write_fixed(to, number->digits, number->exponent);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct Decimal {
  std::uint64_t mantissa = 0;
  int digits = 0;    // significant digits in the mantissa, at most 19
  int exponent = 0;  // value = mantissa * 10^exponent, exact when nothing was dropped
  bool dropped = false;

  void add(char c, bool fraction) {
    if (digits < 19) {
      mantissa = mantissa * 10 + static_cast<unsigned>(c - '0');
      if (mantissa != 0) ++digits;
      if (fraction) --exponent;
    } else {
      dropped = true;
      if (!fraction) ++exponent;
    }
  }
};

constexpr int kExponentLimit = 100000;

std::size_t parse_exponent(std::string_view text, int& value) {
  std::size_t at = 1;
  bool negative = false;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) negative = text[at++] == '-';

  const std::size_t first = at;
  int exponent = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    if (exponent < kExponentLimit) exponent = exponent * 10 + (text[at] - '0');
  }
  if (at == first) return 0;
  value = negative ? -exponent : exponent;
  return at;
}

// Exact for all texts; `number` has no plus sign.
double parse_slowly(std::string_view number, const Decimal& decimal) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc::result_out_of_range) return value;

  const bool huge = decimal.digits + decimal.exponent > 0;
  const double magnitude = huge ? std::numeric_limits<double>::max() : 0.0;
  return number.front() == '-' ? -magnitude : magnitude;
}

double value_of(const Decimal& decimal, std::string_view number) {
  const bool negative = number.front() == '-';
  if (!decimal.dropped && decimal.mantissa <= (std::uint64_t{1} << 53) && decimal.exponent >= -22 &&
      decimal.exponent <= 22) {
    const auto exact = static_cast<double>(decimal.mantissa);
    const double magnitude = decimal.exponent < 0
                                 ? exact / kPowersOfTen[static_cast<std::size_t>(-decimal.exponent)]
                                 : exact * kPowersOfTen[static_cast<std::size_t>(decimal.exponent)];
    return negative ? -magnitude : magnitude;
  }
  return parse_slowly(number.front() == '+' ? number.substr(1) : number, decimal);
}

}  // namespace

char* write_g(double value, char* to) {
  if (char* end = write_round(to, value)) return end;
  if (char* end = write_common(to, value)) return end;
  return std::to_chars(to, to + kMaxNumberLength, value, std::chars_format::general,
                       kSignificantDigits)
      .ptr;
}

// A quotient of two exact numbers is rounded as parsing rounds it.
double rounded_to_text(double value) {
  const double magnitude = std::fabs(value);
  if (const std::optional<unsigned> whole = ten_thousandths(magnitude)) {
    return std::copysign(*whole / kTenThousandths, value);
  }
  if (const std::optional<SixDigits> number = six_digits(magnitude)) {
    const int decimals = kSignificantDigits - 1 - number->exponent;
    return std::copysign(number->digits / kPowersOfTen[static_cast<std::size_t>(decimals)], value);
  }

  std::array<char, kMaxNumberLength> text;
  const char* end = write_g(value, text.data());
  double rounded = value;
  parse_number_prefix({text.data(), static_cast<std::size_t>(end - text.data())}, rounded);
  return rounded;
}

char* write_int(std::int64_t value, char* to) {
  if (value >= 0 && value < 1000) {
    return write_short(to, static_cast<unsigned>(value));
  }
  return std::to_chars(to, to + kMaxNumberLength, value).ptr;
}

void append_g(double value, std::string& out) {
  std::array<char, kMaxNumberLength> text;
  out.append(text.data(), static_cast<std::size_t>(write_g(value, text.data()) - text.data()));
}

void append_int(std::int64_t value, std::string& out) {
  std::array<char, kMaxNumberLength> text;
  out.append(text.data(), static_cast<std::size_t>(write_int(value, text.data()) - text.data()));
}

void append_shortest(double value, std::string& out) {
  assert(std::isfinite(value));
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  out.append(text.data(), static_cast<std::size_t>(end - text.data()));
}

std::size_t parse_number_prefix(std::string_view text, double& value) {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t first = at;
  Decimal decimal;
  for (; at < text.size() && is_digit(text[at]); ++at) decimal.add(text[at], false);
  const bool has_whole = at > first;
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
    for (++at; at < text.size() && is_digit(text[at]); ++at) decimal.add(text[at], true);
  } else if (!has_whole) {
    return 0;
  }

  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    int exponent = 0;
    at += parse_exponent(text.substr(at), exponent);
    decimal.exponent += exponent;
  }

  value = value_of(decimal, text.substr(0, at));
  return at;
}

std::size_t parse_int_prefix(std::string_view text, int& value) {
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t first = at;
  const bool negative = at == 1 && text[0] == '-';

  constexpr std::int64_t kLimit = std::int64_t{1} << 31;
  std::int64_t magnitude = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    if (magnitude < kLimit) magnitude = magnitude * 10 + (text[at] - '0');
  }
  if (at == first) return 0;

  if (negative) {
    value = static_cast<int>(-std::min(magnitude, kLimit));
  } else {
    value = static_cast<int>(std::min(magnitude, kLimit - 1));
  }
  return at;
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  if (text.empty() || parse_number_prefix(text, value) != text.size()) return std::nullopt;
  return value;
}

std::optional<int> parse_int(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && is_digit(text[1]);
  if (has_plus) text.remove_prefix(1);

  const char* end = text.data() + text.size();
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return stop == end && error == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace cls::base
