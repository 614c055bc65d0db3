// Long balls out of defence: who gets them, and where that leaves us.
#pragma once

#include <optional>

#include "proxy/planner/field.h"

namespace cls::proxy {

/// A ball that is kicked once and then anybody's.
struct Outlet {
  soccer::Vec2 target;  ///< where somebody gets it, or where it leaves the pitch
  double speed = 0.0;   ///< first, metres per cycle
  bool ours = false;    ///< a teammate is there first
  double value = 0.0;   ///< comparable among outlets of the same moment only
};

/// The most promising of the balls that one kick can send upfield; nothing when the ball cannot be
/// kicked anywhere. A ball that a teammate gets with time to spare is best; of the others, the
/// farther from our goal and the nearer to a touch line the better.
std::optional<Outlet> best_outlet(const PlannerField& field);

}  // namespace cls::proxy
