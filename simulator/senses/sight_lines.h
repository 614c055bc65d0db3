// Border lines of the pitch in the line of sight of a player.
#pragma once

#include "base/fixed_list.h"
#include "simulator/world/player.h"
#include "soccer/pitch.h"

namespace cls::simulator {

/// Intersection of the line of sight with a border line.
struct SightLine {
  soccer::PitchLine line = soccer::PitchLine::kLeft;
  double distance = 0.0;   ///< along the line of sight
  double direction = 0.0;  ///< radians: angle between sight and line, as in see messages
};

using SightLines = base::FixedList<SightLine, 2>;

/// In message order. At most one from inside the pitch, two from outside; independent of the view
/// cone (docs/spec/simulation-model.md 7.8).
SightLines lines_in_sight(const Player& player);

}  // namespace cls::simulator
