// What the rules decide: words, the ball's new place, the mode that follows (9.2).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Everybody hears the referee say it; see RefereeSaid.
void announce(World& world, const RefereeSaid& words, Events& events);

/// The ball lies still at `position`, and the next set play is that side's.
void place_ball(World& world, Side side, Vec2 position);

/// That, then the mode. During a shoot-out a request for play_on or drop_ball keeps the mode.
void place_ball(World& world, PlayMode mode, Side side, Vec2 position, Events& events);

// Set plays for `side`; those without a position take the ball's place.
void award_free_kick(World& world, Side side, Vec2 position, Events& events);
void award_goal_kick(World& world, Side side, Events& events);
void award_corner_kick(World& world, Side side, Events& events);
void award_kick_in(World& world, Side side, Events& events);

/// Everybody is sent away from the ball, and play goes on in the same call.
void drop_ball(World& world, Events& events);

/// That, with the ball at `place`, which may be in a penalty area.
void drop_ball(World& world, Vec2 place, Events& events);

}  // namespace cls::simulator
