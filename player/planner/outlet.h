// Outlets: long balls out of defense.
#pragma once

#include <optional>

#include "player/planner/field.h"

namespace cls::player {

/// A long ball by one kick.
struct Outlet {
  soccer::Vec2 target;          ///< where a player gets it or it leaves the pitch
  double speed = 0.0;           ///< first, meters per cycle
  bool teammate_first = false;  ///< a teammate gets it first
  double value = 0.0;           ///< comparable only between outlets of the same step
};

/// Best outlet; empty if no kick is possible. Outlets that a teammate gets with time to spare are
/// best; otherwise those far from our goal and near a touch line.
std::optional<Outlet> best_outlet(const PlannerField& field);

}  // namespace cls::player
