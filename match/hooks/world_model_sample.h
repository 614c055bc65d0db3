// A world model as the decision debugger shows it.
#pragma once

#include "player/world/world_model.h"
#include "viewer/decisions/decision_sample.h"

namespace cls::match {

/// The estimates of a player, in the coordinates of the game log. Without reply and commands.
viewer::DecisionSample sample_of(const player::WorldModel& world);

}  // namespace cls::match
