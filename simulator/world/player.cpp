// View geometry of a player.
#include "simulator/world/player.h"

namespace cls::simulator {

namespace math = soccer::math;

double view_cone(const View& view, double visible_angle) {
  const double normal = math::to_radians(visible_angle);
  switch (view.width) {
    case soccer::ViewWidth::kNarrow:
      return view.synchronous ? normal * 2.0 / 3.0 : normal / 2.0;
    case soccer::ViewWidth::kNormal:
      return view.synchronous ? normal * 4.0 / 3.0 : normal;
    case soccer::ViewWidth::kWide:
      break;
  }
  return normal * 2.0;
}

double face_direction(const Player& player) {
  return math::normalize_radians(player.body + player.neck);
}

Vec2 focus_point(const Player& player) {
  const View& view = player.view;
  const double direction =
      math::normalize_radians(player.body + player.neck + view.focus_direction);
  return player.position + soccer::polar_radians(view.focus_distance, direction);
}

}  // namespace cls::simulator
