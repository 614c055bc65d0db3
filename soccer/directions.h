// Directions of several vectors at little more than the cost of one.
#pragma once

#include <array>
#include <cstddef>

#include "soccer/geometry.h"

namespace cls::soccer {

/// direction_degrees() of both, bit by bit.
std::array<double, 2> direction_pair(Vec2 a, Vec2 b);

/// direction_degrees() of each of `count` vectors, bit by bit, into `degrees`.
void directions(const Vec2* vectors, std::size_t count, double* degrees);

}  // namespace cls::soccer
