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

// Decisions: messages, the new ball position, the next play mode (docs/spec/simulation-model.md
// 9.2), cards.

/// Sends a referee message to all clients.
void announce(World& world, const RefereeMessage& message, Events& events);

/// Stops the ball at `position`; the next set play is that side's.
void place_ball(World& world, Side side, Vec2 position);

/// Places the ball, then changes the mode. During a shoot-out play_on and drop_ball keep the mode.
void place_ball(World& world, PlayMode mode, Side side, Vec2 position, Events& events);

// Award a set play to `side`, at the ball's position if there is no parameter for it.
void award_free_kick(World& world, Side side, Vec2 position, Events& events);
void award_goal_kick(World& world, Side side, Events& events);
void award_corner_kick(World& world, Side side, Events& events);
void award_kick_in(World& world, Side side, Events& events);

/// Clears all players from the ball and resumes play in the same call.
void drop_ball(World& world, Events& events);

/// Same with the ball at `position`, which may be inside a penalty area.
void drop_ball(World& world, Vec2 position, Events& events);

/// Announces the card; a second yellow card is also a red card.
void show_yellow_card(World& world, Player& player, Events& events);

/// Announces the card and sends the player off.
void show_red_card(World& world, Player& player, Events& events);

}  // namespace cls::simulator
