// Delaunay triangulation of points in the plane.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "soccer/geometry.h"

namespace cls::player {

/// Indices into the list of points, counterclockwise (x right, y up).
using Triangle = std::array<std::size_t, 3>;

/// Delaunay triangulation (Bowyer 1981). Points must be at least one centimeter apart; fewer than
/// three points, or points on one line, give no triangles. The result depends only on the points
/// and their order.
std::vector<Triangle> triangulate(const std::vector<soccer::Vec2>& points);

}  // namespace cls::player
