// The areas as predicates.
#include "soccer/areas.h"

#include <array>
#include <cassert>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::soccer {
namespace {

using soccer::Vec2;

constexpr double kGoalHalfWidth = 7.01;

struct Area {
  std::string_view name;
  bool (*contains)(Vec2);
};

// Seen from the goal at -x; the right side's areas are mirrored.
bool in_penalty_area(Vec2 p) {
  return p.x >= -soccer::kHalfLength && p.x <= -soccer::kHalfLength + soccer::kPenaltyAreaLength &&
         std::fabs(p.y) <= soccer::kPenaltyAreaWidth / 2;
}
bool in_goal_area(Vec2 p) {
  return p.x >= -soccer::kHalfLength && p.x <= -soccer::kHalfLength + soccer::kGoalAreaLength &&
         std::fabs(p.y) <= soccer::kGoalAreaWidth / 2;
}
bool in_goal(Vec2 p) { return p.x < -soccer::kHalfLength && std::fabs(p.y) < kGoalHalfWidth; }
bool on_pitch(Vec2 p) {
  return std::fabs(p.x) <= soccer::kHalfLength && std::fabs(p.y) <= soccer::kHalfWidth;
}

constexpr std::array<Area, 10> kAreas = {{
    {"pitch", on_pitch},
    {"left_half", [](Vec2 p) { return on_pitch(p) && p.x <= 0.0; }},
    {"right_half", [](Vec2 p) { return on_pitch(p) && p.x >= 0.0; }},
    {"left_penalty_area", in_penalty_area},
    {"right_penalty_area",
     [](Vec2 p) {
       return in_penalty_area({-p.x, p.y});
     }},
    {"left_goal_area", in_goal_area},
    {"right_goal_area",
     [](Vec2 p) {
       return in_goal_area({-p.x, p.y});
     }},
    {"left_goal", in_goal},
    {"right_goal",
     [](Vec2 p) {
       return in_goal({-p.x, p.y});
     }},
    {"centre_circle",
     [](Vec2 p) {
       return p.x * p.x + p.y * p.y <= soccer::kCentreCircleRadius * soccer::kCentreCircleRadius;
     }},
}};

}  // namespace

const std::vector<std::string_view>& area_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Area& area : kAreas) list.push_back(area.name);
    return list;
  }();
  return names;
}

bool is_in_area(std::string_view name, Vec2 position) {
  for (const Area& area : kAreas) {
    if (area.name == name) return area.contains(position);
  }
  assert(false && "an area of the table");
  return false;
}

}  // namespace cls::soccer
