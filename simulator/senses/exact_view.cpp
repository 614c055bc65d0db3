// Builds the fullstate message and the global view of coaches.
#include "simulator/senses/exact_view.h"

#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"
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

soccer::FullStatePlayer full_state_player(const World& world, const Player& player) {
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
  return world.ball_catcher != kNoPlayer &&
         world.mode ==
             soccer::for_side(PlayMode::kFreeKickLeft, soccer::side_of_slot(world.ball_catcher));
}

// First client versions that receive these fields. Replies to look lag one version behind.
constexpr int kFirstWithArm = 8;
constexpr int kFirstWithKick = 13;
constexpr int kFirstWithFoulAndCard = 14;

soccer::ActionMark mark(const Player& player, int level, bool pointing) {
  if (player.tackle_cycles > 0) return soccer::ActionMark::kTackling;
  if (level < kFirstWithKick) return soccer::ActionMark::kNone;
  if (player.kick_cycles >= 0) return soccer::ActionMark::kKicked;
  if (level < kFirstWithFoulAndCard || pointing || player.foul_cycles <= 0) {
    return soccer::ActionMark::kNone;
  }
  return soccer::ActionMark::kFoulCharged;
}

// In a reply to look, clients before version 13 receive only the pose, later clients the arm too.
int level_of(int version, bool is_look_reply) {
  if (!is_look_reply) return version;
  return version >= kFirstWithKick ? kFirstWithArm : kFirstWithArm - 1;
}

soccer::GlobalViewPlayer global_view_player(const World& world, const Player& player, int level) {
  soccer::GlobalViewPlayer out;
  out.unum = player.unum;
  out.goalie = player.goalie;

  out.position = player.position;
  out.velocity = player.velocity;
  out.body = rounded_degrees(player.body);
  out.neck = rounded_degrees(player.neck);

  if (level < kFirstWithArm) return out;
  out.pointing = is_pointing(world, player);
  if (out.pointing) {
    out.point_direction = rounded_degrees(
        math::normalize_radians(arm_aim(player).direction + player.neck + player.body));
  }

  out.mark = mark(player, level, out.pointing);
  if (level >= kFirstWithFoulAndCard) out.card = card(player);
  return out;
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
    if (other.enabled) out.players.push_back(full_state_player(world, other));
  }
}

void coach_view(const World& world, Side side, int version, bool is_look_reply,
                soccer::GlobalView& out) {
  const int level = level_of(version, is_look_reply);
  out.is_look_reply = is_look_reply;
  out.time = world.clock.time;
  out.ball_position = world.ball.position;
  out.ball_velocity = world.ball.velocity;
  out.players.clear();

  for (const Player& player : world.players) {
    if (!player.enabled) continue;
    out.players.push_back(global_view_player(world, player, level));
    out.players.back().team = visible_team_name(world, side, player.side);
  }
}

}  // namespace cls::simulator
