// Running and turning: go to a point, stop, face something, take a place before kick-off.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/looking/neck_plan.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

// Each returns true when it brought about what it is for (proxy behaviour 4.2); a false one may
// have left `turn 0` in the body slot.

struct RunOptions {
  int horizon = 100;              ///< cycles within which the dash should bring us there
  double turn_margin_deg = 15.0;  ///< smaller errors of heading are run with
  bool save_recovery = true;
};

/// Runs to within `threshold` metres of `target`. False when already there (momentum included).
bool go_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                 double threshold, double max_dash_power, RunOptions options = {});

/// The same around whoever stands in the way.
bool go_to_point_dodge(const WorldModel& world, CommandSlots& slots, soccer::Vec2 target,
                       double dash_power);

/// The same keeping the ball in view, backwards if need be; looks at the ball when there.
bool go_to_point_look_ball(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                           NeckPlan& neck, soccer::Vec2 target, double threshold,
                           double max_dash_power);

/// Dashes against the own velocity. False when it is unknown or next to nothing.
bool stop_dash(const WorldModel& world, CommandSlots& slots, bool save_recovery);

/// Global direction.
bool turn_to_angle(const WorldModel& world, CommandSlots& slots, soccer::AngleDeg angle);
/// Faces the point as seen from where the agent coasts to in `cycles`. False when it does already.
bool turn_to_point(const WorldModel& world, CommandSlots& slots, soccer::Vec2 point,
                   int cycles = 1);
bool turn_to_ball(const WorldModel& world, CommandSlots& slots, int cycles = 1);

/// Moves to the point before kick-off or after a goal, then looks around.
bool before_kick_off(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                     soccer::Vec2 point);

}  // namespace cls::proxy
