// How long ago each direction was looked at.
#pragma once

#include <array>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Global directions in sectors of five degrees; sector 0 begins at -180.
struct SightMemory {
  static constexpr int kSectors = 72;
  std::array<int, kSectors> ages;  ///< cycles since the sector was in view
  GameTime updated;

  SightMemory() { ages.fill(kNever); }

  static int sector_of(soccer::AngleDeg direction);
  /// Sum of the ages of the sectors within `half_width` degrees of `direction`.
  int age_around(soccer::AngleDeg direction, double half_width) const;
};

/// Call once per decision: grows the ages and clears those of what is in view now.
void note_sight(SightMemory& sight, const WorldModel& world);

/// The cone of a width in degrees, in the synchronous vision that our agents use.
double view_angle(const soccer::ServerParams& server, soccer::ViewWidth width);

}  // namespace cls::proxy
