// A pair of values, one for each side of a match.
#pragma once

#include <array>
#include <cassert>

#include "soccer/side.h"

namespace cls::soccer {

inline constexpr std::array<Side, 2> kBothSides = {Side::kLeft, Side::kRight};

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
