// What others may ask about keepaway.
#pragma once

#include "simulator/world/state.h"

namespace cls::simulator {

/// In the step in which an episode ended: true if the takers took the ball, false if it left the
/// area.
bool was_taken(const KeepawayRule& rule);

}  // namespace cls::simulator
