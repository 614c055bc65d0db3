// Ball skills: single kicks, kick sequences, shots, dribbling, holding and clearing the ball.
#pragma once

#include <optional>

#include "player/commands/command_slots.h"
#include "player/commands/intention.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Maximum ball acceleration by one kick now, meters per cycle.
double kick_limit(const WorldModel& world);
/// The kick limit for a given kick rate.
double kick_limit(const WorldModel& world, double rate);

/// Maximum speed along the unit vector `direction` of a ball with `velocity` after an acceleration
/// of at most `limit`; negative if that direction is impossible.
double max_speed_along(Vec2 velocity, Vec2 direction, double limit, double speed_max);

/// Kicks so that the ball velocity becomes `velocity`, or as near as full power allows.
bool kick_to_velocity(const WorldModel& world, CommandSlots& slots, Vec2 velocity);

/// One kick toward the point with `first_speed`, or the highest possible speed below it. If the
/// direction is impossible: with `force_mode` kicks as near to it as possible, otherwise holds the
/// ball.
bool kick_one_step(const WorldModel& world, CommandSlots& slots, Vec2 target, double first_speed,
                   bool force_mode);

/// True if a ball beside the agent is not at rest where it can be kicked: stop_ball() would kick.
bool stop_needs_kick(const WorldModel& world);

/// Keeps the ball at its position relative to the moving agent. False (and `turn 0`) if no kick is
/// needed.
bool stop_ball(const WorldModel& world, CommandSlots& slots);

/// Plans one to `max_steps` (at most 3) kicks that send the ball toward `target` with
/// `first_speed`, and executes the first. If no sequence reaches `speed_threshold`, holds the ball
/// and returns false; also false if the ball is not kickable.
bool smart_kick(const WorldModel& world, CommandSlots& slots, Vec2 target, double first_speed,
                double speed_threshold, int max_steps);

/// Shoots at the goal from within 30 m where no opponent can stop the ball. False if there is no
/// such shot, in indirect free kicks, and while the clock is stopped. `aim`, if not null, receives
/// the target.
bool shoot(const WorldModel& world, CommandSlots& slots, Vec2* aim = nullptr);

/// Turns toward `face_point` (default: their goal) while the ball is safe, otherwise kicks it to
/// the safest point in reach. False if the ball is not kickable.
bool hold_ball(const WorldModel& world, CommandSlots& slots, bool do_turn,
               std::optional<Vec2> face_point);

/// Kicks far upfield in the direction with the most space. False if the ball is not kickable.
bool advance_ball(const WorldModel& world, CommandSlots& slots);

/// Kicks with full power in a free direction, preferably toward the touch line ahead.
bool clear_ball(const WorldModel& world, CommandSlots& slots);

/// In open play, when an opponent can also kick the ball: kicks immediately toward their goal, or
/// in front of it from the wing. False otherwise, and for goalies.
bool force_kick(const WorldModel& world, CommandSlots& slots);

struct DribbleOptions {
  double threshold = 1.0;  ///< arrived within this distance, meters
  double dash_power = 100.0;
  int dash_count = 1;  ///< dashes between kicks, 1 to 10
  bool dodge = false;  ///< avoid opponents
};

/// Dribbles toward `target`: intercepts the ball if it is not kickable, holds it at the target. A
/// kick ahead leaves an intention to run after the ball. False only if frozen.
bool dribble(const WorldModel& world, Intention& intention, CommandSlots& slots, Vec2 target,
             const DribbleOptions& options);

/// Continues the dribble. False, clearing the intention, when it is invalid: another player has the
/// ball, it is out of reach, or the dribble is finished.
bool continue_dribble(const WorldModel& world, Intention& intention, CommandSlots& slots);

}  // namespace cls::player
