// The taker of a set play leaves the ball to others: once it has dashed, a second touch is a free
// kick fault.
#include <variant>

#include "player/behaviors/behaviors.h"
#include "player/movement/movement.h"

namespace cls::player {
namespace {

/// Cycles after which the taker plays a ball that no player fetches: a fault is not worse.
constexpr int kPatience = 40;

bool is_our_set_play(const WorldModel& world) {
  return soccer::is_set_play(world.game.mode) && world.game.mode_side() == world.our_side;
}

/// False when another player has touched the ball, or the referee has stopped play.
bool is_untouched(const WorldModel& world, const SetPlayKick& kick) {
  const bool by_agent =
      world.last_kick.side == world.our_side && world.last_kick.unum == world.unum;
  return by_agent && !world.kickable_teammate() && !world.kickable_opponent() &&
         (world.game.mode == PlayMode::kPlayOn || is_our_set_play(world)) &&
         world.game.time.cycle <= kick.cycle + kPatience;
}

}  // namespace

void update_set_play_kick(const WorldModel& world, SetPlayKick& kick) {
  if (kick.cycle >= 0 && !is_untouched(world, kick)) kick = {};
}

void record_set_play_kick(const WorldModel& world, const CommandSlots& slots, SetPlayKick& kick) {
  if (std::holds_alternative<soccer::Kick>(slots.body()) && is_our_set_play(world)) {
    kick = {world.game.time.cycle, false};
  } else if (std::holds_alternative<soccer::Dash>(slots.body()) ||
             std::holds_alternative<soccer::LegDash>(slots.body())) {
    kick.dashed = true;
  }
}

bool must_leave_ball(const WorldModel& world, const ActionMemory& memory) {
  return memory.set_play_kick.cycle >= 0 && world.game.mode == PlayMode::kPlayOn &&
         world.server().free_kick_faults;
}

bool leave_ball(ActionContext& c) {
  const WorldModel& world = c.world;
  constexpr double kMinRollSpeed = 0.5;  ///< meters per cycle; a slower ball stays
  const bool stuck = world.ball.velocity.length() < kMinRollSpeed;
  if (stuck && !c.memory.set_play_kick.dashed && kick_into_play(c)) return true;
  c.neck.kind = NeckPlan::Kind::kBall;
  return turn_to_ball(world, c.slots) || c.slots.turn(0.0);
}

}  // namespace cls::player
