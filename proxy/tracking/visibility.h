// What the agent's look covers.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Width of the view cone in degrees, for clients in synch mode (version 18 and later always are).
double view_angle(const WorldModel& world, soccer::ViewWidth width);

/// True when something believed at `position`, give or take `deviation` per axis, cannot have been
/// missed by the present look: inside the cone or within the radius of closeness, with a margin.
bool must_be_visible(const WorldModel& world, soccer::Vec2 position, double deviation);

}  // namespace cls::proxy
