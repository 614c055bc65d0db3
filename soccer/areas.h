// Areas of the pitch that scenarios name.
#pragma once

#include <string_view>
#include <vector>

#include "soccer/geometry.h"

namespace cls::soccer {

/// left_penalty_area, right_goal, centre_circle, pitch, ... in the server's axes.
const std::vector<std::string_view>& area_names();

/// `name` must be one of them. A goal is what lies behind the line between the posts.
bool is_in_area(std::string_view name, soccer::Vec2 position);

}  // namespace cls::soccer
