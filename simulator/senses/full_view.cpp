// The noise-free world for one player.
#include "simulator/senses/full_view.h"

#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/world/angles.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

soccer::ActionMark mark(const Player& player) {
  if (player.tackle_cycles > 0) return soccer::ActionMark::kTackling;
  if (player.kick_cycles >= 0) return soccer::ActionMark::kKicked;
  if (player.foul_cycles > 0) return soccer::ActionMark::kFoulCharged;
  return soccer::ActionMark::kNone;
}

soccer::FullStatePlayer describe(const World& world, const Player& player) {
  soccer::FullStatePlayer out;
  out.side = player.side;
  out.unum = player.unum;
  out.goalie = player.goalie;
  out.type = player.type;
  out.position = player.position;
  out.velocity = player.velocity;
  out.body = exact_degrees(player.body);
  out.neck = exact_degrees(player.neck);
  if (is_pointing(world, player)) {
    const ArmAim aim = arm_aim(player);
    out.pointing = true;
    out.point_distance = aim.distance;
    out.point_direction_radians = aim.direction;
  }
  out.focus_distance = player.view.focus_distance;
  out.focus_direction = exact_degrees(player.view.focus_direction);
  out.stamina = player.stamina.value;
  out.effort = player.stamina.effort;
  out.recovery = player.stamina.recovery;
  out.capacity = player.stamina.capacity;
  out.mark = mark(player);
  out.card = card(player);
  return out;
}

bool goalie_holds_ball(const World& world) {
  return world.ball_catcher != kNobody &&
         world.mode ==
             soccer::for_side(PlayMode::kFreeKickLeft, soccer::side_of_slot(world.ball_catcher));
}

}  // namespace

bool has_full_state(const World& world, const Player& player) {
  return player.side == Side::kLeft ? world.params().fullstate_l : world.params().fullstate_r;
}

void full_state(const World& world, Slot slot, soccer::FullState& out) {
  const Player& player = world.player(slot);
  out.time = world.clock.time;
  out.mode = world.mode;
  out.ball_caught = goalie_holds_ball(world);
  out.quality = player.view.quality;
  out.width = player.view.width;
  out.counts = command_counts(player.counters);
  out.arm = arm_state(world, player, false);
  out.our_score = world.team(player.side).score;
  out.opponent_score = world.team(soccer::opponent(player.side)).score;
  out.ball_position = world.ball.position;
  out.ball_velocity = world.ball.velocity;
  out.players.clear();
  for (const Player& other : world.players) {
    if (other.enabled) out.players.push_back(describe(world, other));
  }
}

}  // namespace cls::simulator
