// The noise-free world in whole degrees.
#include "simulator/senses/coach_view.h"

#include <cmath>

#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

// What a version is shown beside the pose; a look is one step behind see_global.
constexpr int kFirstWithArm = 8;
constexpr int kFirstWithKick = 13;
constexpr int kFirstWithFoulAndCard = 14;

int rounded_degrees(double radians) { return static_cast<int>(std::rint(exact_degrees(radians))); }

soccer::ActionMark mark(const Player& player, int level, bool pointing) {
  if (player.tackle_cycles > 0) return soccer::ActionMark::kTackling;
  if (level < kFirstWithKick) return soccer::ActionMark::kNone;
  if (player.kick_cycles >= 0) return soccer::ActionMark::kKicked;
  if (level < kFirstWithFoulAndCard || pointing || player.foul_cycles <= 0) {
    return soccer::ActionMark::kNone;
  }
  return soccer::ActionMark::kFoulCharged;
}

// Of a look, clients are shown what was new in the version before; all before 13 the pose alone.
int level_of(int version, bool is_look_reply) {
  if (!is_look_reply) return version;
  return version >= kFirstWithKick ? kFirstWithArm : kFirstWithArm - 1;
}

soccer::GlobalViewPlayer describe(const World& world, const Player& player, int level) {
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
    out.players.push_back(describe(world, player, level));
    out.players.back().team = shown_name(world, side, player.side);
  }
}

}  // namespace cls::simulator
