// Simulates a step so that outcomes decided by noise match the record.
#pragma once

#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// Outcomes of a step that noise decided.
struct NoiseDecisions {
  bool line = false;     ///< which line the ball crossed or which post it passed
  bool toucher = false;  ///< which of two contacts in one cycle was stronger
};

/// Steps `world`, which must have overrides. If the mode differs from the record, tries other noise
/// of the ball and each of `contestants` as the last toucher. Keeps the first trial if none leads
/// to the recorded mode.
NoiseDecisions step_as_recorded(World& world, Events& events, const gamelog::Frame& after,
                                const std::vector<Slot>& contestants);

}  // namespace cls::simulator
