// The classes of the planner's candidates: which of them belong to an option.
#pragma once

#include <vector>

#include "player/options/option_ids.h"
#include "player/planner/field.h"
#include "player/planner/plan.h"

namespace cls::player {

/// All dribbles and passes that the planner's generators find, which no opponent stops.
std::vector<PlanAction> ball_candidates(const PlannerField& field);

/// The option of a dribble or a pass of the agent; -1 for other actions, and for receivers that are
/// not other players of the team.
int option_class(const WorldModel& world, const PlanAction& action);

}  // namespace cls::player
