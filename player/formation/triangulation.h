// Delaunay triangulation of points in the plane.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "soccer/geometry.h"

namespace cls::player {

using soccer::Vec2;

/// Indices into the list of points, counterclockwise (x right, y up).
using Triangle = std::array<std::size_t, 3>;
using Edge = std::pair<std::size_t, std::size_t>;

/// Delaunay triangulation (Bowyer 1981). Points must be at least one centimeter apart; fewer than
/// three points, or points on one line, give no triangles. The result depends only on the points
/// and their order.
std::vector<Triangle> triangulate(const std::vector<Vec2>& points);

/// Edges that belong to exactly one of the triangles: the boundary of their union.
std::vector<Edge> boundary(const std::vector<Triangle>& triangles);

}  // namespace cls::player
