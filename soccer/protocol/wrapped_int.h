// Integers in client messages, with the overflow behavior of rcssserver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "base/text/number_text.h"

namespace cls::soccer {

/// Like parse_int_prefix, but values beyond the range of an int wrap to their lowest 32 bits, after
/// clamping to 64 bits, as with atoi and sscanf in rcssserver.
inline std::size_t parse_wrapped_int(std::string_view text, int& value) {
  const std::size_t length = base::parse_int_prefix(text, value);
  if (length == 0) return 0;
  const bool negative = text[0] == '-';
  const std::size_t first = negative || text[0] == '+' ? 1 : 0;
  if (length - first <= std::numeric_limits<int>::digits10) return length;  // in range
  std::int64_t wide = 0;
  for (const char digit : text.substr(first, length - first)) {
    const std::int64_t next = negative ? '0' - digit : digit - '0';
    if (__builtin_mul_overflow(wide, std::int64_t{10}, &wide) ||
        __builtin_add_overflow(wide, next, &wide)) {
      using Limits = std::numeric_limits<std::int64_t>;
      wide = negative ? Limits::min() : Limits::max();
      break;
    }
  }
  value = static_cast<int>(static_cast<std::uint32_t>(wide));
  return length;
}

}  // namespace cls::soccer
