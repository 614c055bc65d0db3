// Body actions without the ball: go to a point, stop, turn, move before kick-off, intercept,
// tackle.
#pragma once

#include "player/commands/command_slots.h"
#include "player/looking/looking.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

// Each returns true on success (docs/spec/proxy-behavior.md 4.2); on failure the body slot may
// contain `turn 0`.

struct RunOptions {
  int horizon = 100;              ///< cycles within which one dash should reach the target
  double turn_margin_deg = 15.0;  ///< no turn for smaller heading errors
  bool save_recovery = true;
};

/// Runs to within `threshold` meters of `target`. False when already there, inertia included.
bool go_to_point(const WorldModel& world, CommandSlots& slots, Vec2 target, double threshold,
                 double max_dash_power, RunOptions options = {});

/// go_to_point() around players in the way.
bool go_to_point_dodge(const WorldModel& world, CommandSlots& slots, Vec2 target,
                       double dash_power);

/// go_to_point() with the ball in view, backward if necessary; faces the ball at the target.
bool go_to_point_look_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                           NeckPlan& neck, Vec2 target, double threshold, double max_dash_power);

/// Dashes against the own velocity. False if it is unknown or nearly zero.
bool stop_dash(const WorldModel& world, CommandSlots& slots, bool save_recovery);

/// Turns the body to a global direction.
bool turn_to_angle(const WorldModel& world, CommandSlots& slots, AngleDeg angle);
/// Turns to the point as seen from the coasting position in `cycles`. False if already facing it.
bool turn_to_point(const WorldModel& world, CommandSlots& slots, Vec2 point, int cycles = 1);
bool turn_to_ball(const WorldModel& world, CommandSlots& slots, int cycles = 1);

/// Moves to the point before kick-off or after a goal, then scans the field.
bool before_kick_off(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                     Vec2 point);

/// Executes the best plan, or runs to the ball's rest point without one. `face_point` is the body
/// target while waiting. True unless the player is frozen.
bool intercept(const WorldModel& world, CommandSlots& slots, bool save_recovery, Vec2 face_point);

/// Tackles the ball toward the point. False if the success probability is below `min_probability`,
/// or the ball would go more than 90 degrees off or slower than `min_speed`.
bool tackle_to_point(const WorldModel& world, CommandSlots& slots, Vec2 target,
                     double min_probability, double min_speed);

/// Tackles when an opponent has or gets the ball, or it rolls into our goal, and the success
/// probability is at least `min_probability`. Fouls intentionally where that pays.
bool basic_tackle(const WorldModel& world, CommandSlots& slots, double min_probability);

}  // namespace cls::player
