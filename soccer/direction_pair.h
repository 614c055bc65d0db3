// Directions of vectors in pairs.
#pragma once

#include <array>

#include "soccer/geometry.h"

namespace cls::soccer {

/// direction_degrees() of both, bit by bit, for little more than the price of one.
std::array<double, 2> direction_pair(Vec2 a, Vec2 b);

}  // namespace cls::soccer
