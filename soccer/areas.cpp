// Predicates of the named areas.
#include "soccer/areas.h"

#include <array>
#include <cassert>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::soccer {
namespace {

constexpr double kGoalHalfWidth = 7.01;

struct Area {
  std::string_view name;
  bool (*contains)(Vec2);
};

// Areas of the left side; those of the right side are mirrored.
bool in_penalty_area(Vec2 p) {
  return p.x >= -kHalfLength && p.x <= -kHalfLength + kPenaltyAreaLength &&
         std::fabs(p.y) <= kPenaltyAreaWidth / 2;
}
bool in_goal_area(Vec2 p) {
  return p.x >= -kHalfLength && p.x <= -kHalfLength + kGoalAreaLength &&
         std::fabs(p.y) <= kGoalAreaWidth / 2;
}
bool in_goal(Vec2 p) { return p.x < -kHalfLength && std::fabs(p.y) < kGoalHalfWidth; }
bool in_center_circle(Vec2 p) {
  return p.x * p.x + p.y * p.y <= kCenterCircleRadius * kCenterCircleRadius;
}
bool on_pitch(Vec2 p) { return std::fabs(p.x) <= kHalfLength && std::fabs(p.y) <= kHalfWidth; }

template <bool (*is_in_left)(Vec2)>
bool mirrored(Vec2 p) {
  return is_in_left({-p.x, p.y});
}

constexpr std::array<Area, 11> kAreas = {{
    {"pitch", on_pitch},
    {"left_half", [](Vec2 p) { return on_pitch(p) && p.x <= 0.0; }},
    {"right_half", [](Vec2 p) { return on_pitch(p) && p.x >= 0.0; }},
    {"left_penalty_area", in_penalty_area},
    {"right_penalty_area", mirrored<in_penalty_area>},
    {"left_goal_area", in_goal_area},
    {"right_goal_area", mirrored<in_goal_area>},
    {"left_goal", in_goal},
    {"right_goal", mirrored<in_goal>},
    {"center_circle", in_center_circle},
    {"centre_circle", in_center_circle},  // former spelling, still accepted
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
  assert(false && "unknown area");
  return false;
}

}  // namespace cls::soccer
