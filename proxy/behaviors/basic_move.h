// Play without the ball: tackle, go for it, stand in the way, or take the own place.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/looking/neck_plan.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Always true, except on the ground. `recovering` is the agent's memory of saving stamina.
bool basic_move(const WorldModel& world, CommandSlots& slots, NeckPlan& neck, bool& recovering);

/// The dash power that suits situation and stamina (proxy behaviour 6.4). Turns `recovering` on
/// when stamina falls below half, off above 70 percent.
double normal_dash_power(const WorldModel& world, bool& recovering);

}  // namespace cls::proxy
