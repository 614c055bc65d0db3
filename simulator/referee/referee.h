// Interface of the referee to the rest of the simulator.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

// Each function calls the rules in their fixed order: time, ball stuck, offside, free kick, touch,
// catch, foul, illegal defense, keepaway, penalty. Without a referee it calls none.

/// Applies the rules after motion.
void run_referee(World& world, Events& events);

// Report actions of players. `acceleration`: length of the acceleration given to the ball.
void on_kick_taken(World& world, Slot kicker, double acceleration, Events& events);
void on_tackle_taken(World& world, Slot tackler, double acceleration, bool foul, Events& events);
void on_ball_missed(World& world, Slot player, Events& events);  ///< kick or tackle without a ball
void on_ball_touched(World& world, Slot toucher, Events& events);
void on_ball_caught(World& world, Slot catcher, Events& events);
void on_ball_punched(World& world, Slot catcher, Events& events);

/// Changes the mode, notifies the rules, clears players from the ball and announces the mode
/// (docs/spec/simulation-model.md 9.2).
void change_mode(World& world, PlayMode mode, Events& events);

/// Starts a half for a monitor, a trainer or auto mode (docs/spec/simulation-model.md 9.6). Ignored
/// when no half can start.
void kick_off(World& world, Events& events);

}  // namespace cls::simulator
