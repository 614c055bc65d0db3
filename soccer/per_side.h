// A pair of values, one for each side of a match.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include "soccer/side.h"

namespace cls::soccer {

inline constexpr std::array<Side, 2> kBothSides = {Side::kLeft, Side::kRight};

/// The index of a side in arrays of two: left 0, right 1.
constexpr std::size_t side_index(Side side) {
  assert(side != Side::kNeutral);
  return side == Side::kLeft ? 0 : 1;
}

template <typename T>
struct PerSide {
  T left{};
  T right{};

  /// The value of a side that is not neutral.
  constexpr T& operator[](Side side) {
    assert(side != Side::kNeutral);
    return side == Side::kLeft ? left : right;
  }
  constexpr const T& operator[](Side side) const {
    assert(side != Side::kNeutral);
    return side == Side::kLeft ? left : right;
  }
};

}  // namespace cls::soccer
