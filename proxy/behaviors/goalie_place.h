// Where a goalie waits.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Where the goalie stands for a ball at that place: from afar on the line that bisects ball and
/// goal, from nearer where it leaves least of the goal open to shots from the ball and from
/// opponents to whom it may be passed.
soccer::Vec2 goalie_place(const WorldModel& world, soccer::Vec2 ball);

}  // namespace cls::proxy
