// Counts in messages.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cls::base {

/// "1 match", "2 matches"; without `many`: "1 warning", "2 warnings".
template <typename Number>
std::string counted(Number number, std::string_view one, std::string_view many = {}) {
  if (number == 1) return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", number, one) : fmt::format("{} {}", number, many);
}

}  // namespace cls::base
