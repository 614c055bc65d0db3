// Delaunay triangulation of points in the plane.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "soccer/geometry.h"

namespace cls::proxy {

/// Indices into the list of points, counter-clockwise in the mathematical sense (x right, y up).
using Triangle = std::array<std::size_t, 3>;

/// Every point a corner, no corner inside another triangle's circumcircle (Bowyer 1981). Points
/// must differ by a centimetre or more; fewer than three, or points on one line, give no triangles.
/// The same points in the same order give the same list.
std::vector<Triangle> triangulate(const std::vector<soccer::Vec2>& points);

}  // namespace cls::proxy
