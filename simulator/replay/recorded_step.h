// A step as it was recorded: where noise decides what a frame no longer shows, the one of its
// possible outcomes that the record tells of.
#pragma once

#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// What noise decided; both would have been possible.
struct OpenOutcomes {
  bool line = false;     ///< over which line or past which post the ball went
  bool toucher = false;  ///< which of two contacts in one cycle was the stronger
};

/// Steps `world`, whose outcomes must be forced. If the mode comes out otherwise than recorded,
/// other noises of the ball are tried, and each of `contestants` as the one who touched it last; if
/// no trial leads to the recorded mode, the first stands.
OpenOutcomes step_as_recorded(World& world, Events& events, const gamelog::Frame& after,
                              const std::vector<Slot>& contestants);

}  // namespace cls::simulator
