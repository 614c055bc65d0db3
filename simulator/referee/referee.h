// The referee as the rest of the simulator calls it.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

// Everything below asks the rules in their fixed order (time, ball stuck, offside, free kick,
// touch, catch, foul, illegal defence, keepaway, penalty), and none when the match has no referee.

/// Looks at the world after it has moved.
void run_referee(World& world, Events& events);

// What players did. `acceleration` is the length of what the ball was given.
void on_kick_taken(World& world, Slot kicker, double acceleration, Events& events);
void on_tackle_taken(World& world, Slot tackler, double acceleration, bool foul, Events& events);
void on_ball_missed(World& world, Slot who, Events& events);  ///< kick or tackle without a ball
void on_ball_touched(World& world, Slot toucher, Events& events);
void on_ball_caught(World& world, Slot catcher, Events& events);
void on_ball_punched(World& world, Slot catcher, Events& events);

/// Changes the mode with all that follows: rules are told, players cleared from the ball, the mode
/// announced (9.2).
void change_mode(World& world, PlayMode mode, Events& events);

/// The command that starts a half: of a monitor, a trainer, or auto mode (9.6). Ignored at a time
/// when no half can start.
void kick_off(World& world, Events& events);

}  // namespace cls::simulator
