// Parts of the penalty rule: the score of a shoot-out and the positions of the players
// (docs/spec/simulation-model.md 9.14).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

// End a kick of that side: set the mode, update the score, and decide the match if possible.
void count_goal(World& world, Side side, Events& events);
void count_miss(World& world, Side side, Events& events);

/// Records a kick, so that every player kicks before any player kicks again.
void record_kicker(World& world, Side side, const Player& kicker);
bool has_kicked(const World& world, const Player& player);

/// True if all players of the team stand where the rules require at a kick.
bool is_team_placed(const World& world, Side side);

/// Moves the team's players to the required positions; velocities stay.
void place_team(World& world, Side side);

}  // namespace cls::simulator
