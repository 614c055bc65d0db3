// How everything moves in a cycle: acceleration, noise, wind, posts, decay (3.1 to 3.3).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Before kick-off: players take their new angles and stand still.
void turn_players(World& world);

/// Ball and players move, collide, and a caught ball goes with its catcher.
void move_objects(World& world, Events& events);

/// Noise of movement and turns of this player, relative to its speed or moment.
double player_rand(const World& world, const Player& player);

/// Factor on the player's limits in the upper half of the pitch, usually 1.
double slowness_on_top(const World& world, const Player& player);

}  // namespace cls::simulator
