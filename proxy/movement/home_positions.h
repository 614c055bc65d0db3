// Where each of our players belongs at the moment, by the team's formations.
#pragma once

#include "proxy/formation/formation.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// The formation for the present mode: after their or our reach of the ball in open play, by who is
/// to play a dead ball otherwise (proxy behaviour 6.4).
FormationKind formation_kind(const WorldModel& world);

/// Points by unum - 1, own team attacking +x: State.helios_home_positions. Depends on the mode and
/// on where the ball will be reached first; respects the own half before kick-off and the offside
/// line.
TeamPoints home_positions(const WorldModel& world);

/// The agent's own point.
soccer::Vec2 own_home_position(const WorldModel& world);

}  // namespace cls::proxy
