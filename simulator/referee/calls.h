// Referee decisions: messages, the new ball position, the next play mode
// (docs/spec/simulation-model.md 9.2), cards.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

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
