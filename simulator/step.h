// One simulation step, in two parts: the frame is sent and logged between them.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Applies dashes, motion, clock, referee and stamina: steps 1 to 4 of the cycle
/// (docs/spec/simulation-model.md 2.2). The world then holds the frame of the new cycle for
/// monitors and the game log. The caller resets the "done" flags of coaches and sends them new
/// messages.
void step(World& world, Events& events);

/// Finishes the step after the frame was sent: clears transient state bits, then runs auto mode
/// (steps 7 and 8).
void finish_step(World& world, Events& events);

/// Counts one step of auto mode (server::auto_mode, 9.16): kicks off when a wait is over and sets
/// auto_mode.ended game_over_wait steps after the match. Does nothing if auto_mode is off.
void run_auto_mode(World& world, Events& events);

}  // namespace cls::simulator
