// The view cone with the margins that a belief needs.
#include "proxy/tracking/visibility.h"

#include <cmath>

#include "soccer/math.h"

namespace cls::proxy {

namespace math = soccer::math;

double view_angle(const WorldModel& world, soccer::ViewWidth width) {
  const double base = world.server().visible_angle;
  switch (width) {
    case soccer::ViewWidth::kNarrow:
      return base * 2.0 / 3.0;
    case soccer::ViewWidth::kNormal:
      return base * 4.0 / 3.0;
    case soccer::ViewWidth::kWide:
      return base * 2.0;
  }
  return base;
}

bool must_be_visible(const WorldModel& world, soccer::Vec2 position, double deviation) {
  const soccer::Vec2 offset = position - world.self.position;
  const double distance = offset.length();
  constexpr double kSure = 2.5;  // standard deviations
  const double blur = kSure * deviation;
  if (distance + blur < world.server().visible_distance - 0.1) return true;
  if (distance <= blur) return false;
  const double angle = (soccer::AngleDeg::of(offset) - world.self.face()).abs();
  const double margin = math::to_degrees(math::asin(blur / distance)) + 1.0;
  return angle + margin < 0.5 * view_angle(world, world.self.view_width);
}

}  // namespace cls::proxy
