// Indices of arrays from signed numbers and enumerators.
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>

namespace cls::base {

/// `value` as an index; it must not be negative.
template <typename Integer>
requires(std::is_integral_v<Integer>) constexpr std::size_t index(Integer value) {
  if constexpr (std::is_signed_v<Integer>) assert(value >= 0);
  return static_cast<std::size_t>(value);
}

/// The number of an enumerator.
template <typename Enum>
requires(std::is_enum_v<Enum>) constexpr std::size_t index(Enum value) {
  return static_cast<std::size_t>(value);
}

}  // namespace cls::base
