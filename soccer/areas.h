// Named areas of the pitch, for scenarios.
#pragma once

#include <string_view>
#include <vector>

#include "soccer/geometry.h"

namespace cls::soccer {

/// left_penalty_area, right_goal, center_circle, pitch, ... in server coordinates.
const std::vector<std::string_view>& area_names();

/// `name` must be one of area_names(). A goal is the area behind the goal line between the posts.
bool is_in_area(std::string_view name, soccer::Vec2 position);

}  // namespace cls::soccer
