// Home positions of our players by the team's formations.
#pragma once

#include "player/formation/formation.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Formation for the play mode: in open play by which team intercepts the ball first, otherwise by
/// the team that takes the set play (docs/spec/proxy-behavior.md 6.4).
FormationKind formation_kind(const WorldModel& world);

/// Home positions by unum - 1, own team attacks +x (State.helios_home_positions). Depend on the
/// mode and the expected intercept point; respect the own half before kick-off and the offside
/// line.
TeamPoints home_positions(const WorldModel& world);

/// Home position of the agent.
Vec2 own_home_position(const WorldModel& world);

}  // namespace cls::player
