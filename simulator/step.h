// One simulation step, cut in two where the frame is sent and logged.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Legs, motion, clock, referee, stamina: steps 1 to 4 of the cycle (simulation model 2.2). What
/// the world says afterwards is the frame of the new cycle for monitors and the game log. Clearing
/// "done" of coaches and handing them new messages is up to whoever keeps the coaches.
void step(World& world, Events& events);

/// After the frame: transient state bits go, then auto mode counts (steps 7 and 8).
void finish_step(World& world, Events& events);

}  // namespace cls::simulator
