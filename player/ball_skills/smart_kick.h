// Kick sequences of up to three kicks for higher ball speeds.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Plans one to `max_steps` (at most 3) kicks that send the ball toward `target` with
/// `first_speed`, and executes the first. If no sequence reaches `speed_threshold`, holds the ball
/// and returns false; also false if the ball is not kickable.
bool smart_kick(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                double first_speed, double speed_threshold, int max_steps);

}  // namespace cls::player
