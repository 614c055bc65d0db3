// Directions of several vectors, and vectors of several directions, at little more than the cost of
// one.
#pragma once

#include <array>
#include <cstddef>

#include "soccer/geometry.h"

namespace cls::soccer {

/// direction_degrees() of both, bit by bit.
std::array<double, 2> direction_pair(Vec2 a, Vec2 b);

/// direction_degrees() of each of `count` vectors, bit by bit, into `degrees`.
void directions(const Vec2* vectors, std::size_t count, double* degrees);

/// direction_radians() of each of `count` vectors, bit by bit, into `radians`.
void directions_radians(const Vec2* vectors, std::size_t count, double* radians);

/// polar_radians(1.0, angle) of each of `count` angles, bit by bit, into `vectors`.
void unit_vectors(const double* radians, std::size_t count, Vec2* vectors);

}  // namespace cls::soccer
