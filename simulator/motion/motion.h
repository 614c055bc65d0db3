// Motion in one cycle: acceleration, noise, wind, goal posts, decay
// (docs/spec/simulation-model.md 3.1 to 3.3).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Before kick-off: commits the angles of players and stops them.
void turn_players(World& world);

/// Moves ball and players, resolves collisions and carries a caught ball with its catcher.
void move_objects(World& world, Events& events);

/// Relative noise of the player's motion and turns.
double player_rand(const World& world, const Player& player);

/// Factor on the player's speed and acceleration limits in the upper half of the pitch; default 1.
double slowness_on_top(const World& world, const Player& player);

/// Adds `velocity` to `position` and reflects both at goal posts in the path
/// (docs/spec/simulation-model.md 3.3). Returns true after a
/// bounce. Draws from `stream` only if the object is exactly at the center of a post.
bool advance_past_posts(Vec2& position, Vec2& velocity, double radius, double goal_width,
                        RandomStream& stream);

}  // namespace cls::simulator
