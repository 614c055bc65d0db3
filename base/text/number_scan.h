// Fast scanners for the short numbers of game logs: eight characters at a time (SWAR).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace cls::base {

// Hand-written because game logs are parsed in the hot path (bench/log_bench.cpp). All functions
// may read 16 bytes after `at`, which must be readable. They move `at` behind the number and return
// true, or leave it unchanged and return false.

/// Logs hold positions, angles and stamina; larger values are errors.
constexpr double kMaxNumber = 1e9;

/// A number of a log that scan_number() rejects: beyond kMaxNumber, "inf" or "nan", with a sign or
/// without. The value is the nearest one in range, 0 for "nan".
bool scan_number_out_of_range(const char*& at, float& value);

namespace detail {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t repeat(std::uint8_t byte) { return 0x0101010101010101ULL * byte; }

inline std::uint64_t load8(const char* at) {
  std::uint64_t bytes;
  std::memcpy(&bytes, at, sizeof bytes);
  return bytes;
}

/// Number of leading characters with a bit that all digits have, and '.', ' ' and ')' have not.
inline int count_digit_like(std::uint64_t bytes) {
  return std::countr_zero(~bytes & repeat(0x10)) / 8;
}

/// The value of the first `count` (1 to 8) characters; clears `ok` if one is not a digit.
inline std::uint32_t digits_value(std::uint64_t bytes, int count, bool& ok) {
  std::uint64_t digits = (bytes ^ repeat('0')) << (64 - 8 * count);
  ok = ok && ((((digits + repeat(6)) | digits) & repeat(0xF0)) == 0);
  digits = digits * 10 + (digits >> 8);
  digits = (((digits & 0x000000FF000000FFULL) * 0x000F424000000064ULL) +
            (((digits >> 16) & 0x000000FF000000FFULL) * 0x0000271000000001ULL)) >>
           32;
  return static_cast<std::uint32_t>(digits);
}

constexpr std::array<double, 8> kTenths = {1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};

/// Half of the numbers of a game log.
inline bool is_one_digit(const char* at) {
  return *at >= '0' && *at <= '9' && (at[1] == ' ' || at[1] == ')');
}

/// Numbers of any form: exponents, many digits. Slow and exact.
bool scan_any_number(const char*& at, float& value);
bool scan_any_integer(const char*& at, std::int32_t& value);

}  // namespace detail

/// A decimal number.
inline bool scan_number(const char*& at, float& value) {
  if (detail::is_one_digit(at)) {
    value = static_cast<float>(*at++ - '0');
    return true;
  }

  const char* start = at + (*at == '-' ? 1 : 0);
  const std::uint64_t bytes = detail::load8(start);
  const int whole = detail::count_digit_like(bytes);
  if (whole == 8 || whole == 0) return detail::scan_any_number(at, value);

  bool ok = true;
  int length = whole;
  std::uint64_t digits = bytes;
  int fraction = 0;
  if (start[whole] == '.') {
    const int shift = 8 * whole;
    const std::uint64_t below = (std::uint64_t{1} << shift) - 1;
    digits = (bytes & below) | ((bytes >> 8) & ~below);
    length = detail::count_digit_like(digits);
    fraction = length - whole;
    if (fraction == 0 || (length == 7 && (start[8] & 0x10) != 0))
      return detail::scan_any_number(at, value);
  }

  const std::uint32_t magnitude = detail::digits_value(digits, length, ok);
  const char* end = start + length + (fraction > 0 ? 1 : 0);
  if (!ok || *end == 'e' || *end == 'E') return detail::scan_any_number(at, value);

  const double exact = magnitude * detail::kTenths[static_cast<std::size_t>(fraction)];
  value = static_cast<float>(start == at ? exact : -exact);
  at = end;
  return true;
}

/// A decimal integer.
inline bool scan_integer(const char*& at, std::int32_t& value) {
  if (detail::is_one_digit(at)) {
    value = *at++ - '0';
    return true;
  }

  const std::uint64_t bytes = detail::load8(at);
  const int length = detail::count_digit_like(bytes);
  if (length == 8 || length == 0) return detail::scan_any_integer(at, value);

  bool ok = true;
  const std::uint32_t magnitude = detail::digits_value(bytes, length, ok);
  if (!ok) return detail::scan_any_integer(at, value);

  value = static_cast<std::int32_t>(magnitude);
  at += length;
  return true;
}

}  // namespace cls::base
