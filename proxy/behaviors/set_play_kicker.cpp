// Behind the ball, a look around, a pass.
#include "proxy/behaviors/set_play_kicker.h"

#include <algorithm>
#include <cmath>

#include "proxy/behaviors/kick_into_play.h"
#include "proxy/movement/home_positions.h"
#include "proxy/movement/movement.h"
#include "proxy/world/motion.h"
#include "soccer/mode_kind.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::PlayMode;
using soccer::Vec2;

/// The direction from which the kicker comes to the ball.
AngleDeg kick_direction(const WorldModel& world) {
  const PlayMode kind = kind_of(world.game.mode);
  const Vec2 ball = world.ball.position;
  if (kind == PlayMode::kKickInLeft) return AngleDeg(ball.y > 0.0 ? -90.0 : 90.0);
  if (kind == PlayMode::kCornerKickLeft) return AngleDeg::of(Vec2{44.0, 0.0} - ball);
  return AngleDeg(0.0);
}

/// Where the kicker looks while it waits: to and fro where its teammates are.
AngleDeg waiting_direction(const WorldModel& world, AngleDeg direction) {
  if (kind_of(world.game.mode) == PlayMode::kKickOffLeft) direction = AngleDeg(180.0);
  constexpr double kSweep = 40.0;
  return direction + (world.game.time.cycle % 8 < 4 ? kSweep : -kSweep);
}

/// Time for the others to be where they should, and for the kicker's stamina.
bool others_need_time(const WorldModel& world) {
  const GameState& game = world.game;
  const int since = game.time.cycle - game.last_set_play_start;
  const PlayMode kind = kind_of(game.mode);
  constexpr int kDropMargin = 5;
  if (since >= world.server().drop_ball_time - kDropMargin) return false;
  if (game.set_play_count < 3) return true;
  const bool seen = game.see_time == game.time.cycle;
  const int patience = kind == PlayMode::kKickOffLeft    ? 20
                       : kind == PlayMode::kGoalKickLeft ? 30
                                                         : 12;
  return since < patience || !seen;
}

bool waits_for_teammates(const WorldModel& world) {
  for (const HeardMessage& heard : world.heard) {
    const bool mate = !heard.coach && heard.side == world.our_side && heard.unum != world.unum;
    if (mate && heard.text.starts_with('w')) return true;
  }
  return false;
}

/// Not onto the ball: around it to the place behind.
bool go_behind_ball(ActionContext& c, AngleDeg direction) {
  const WorldModel& world = c.world;
  const Vec2 ball = world.ball.position;
  const double gap = collide_distance(world) + 0.25;
  const Vec2 place = ball - soccer::polar(gap, direction);
  const double away = distance(world.self.position, place);
  c.neck.kind = world.ball.pos_count > 2 ? NeckPlan::Kind::kBall : NeckPlan::Kind::kBallOrScan;
  constexpr double kClose = 0.25;
  if (away < kClose || (world.self.kickable && away < 0.6)) return false;
  // Slowly in the end: running into the ball would move it.
  const double power = away < 2.0 ? 40.0 : away < 5.0 ? 70.0 : world.server().max_dash_power;
  const AngleDeg way = AngleDeg::of(place - world.self.position);
  const AngleDeg to_ball = AngleDeg::of(ball - world.self.position);
  const bool in_the_way = distance(ball, world.self.position) < away + 0.3 &&
                          (way - to_ball).abs() < 45.0 && away > 0.6;
  if (in_the_way) {
    return go_to_point_dodge(world, c.slots, place, safe_dash_power(world, power));
  }
  return go_to_point(world, c.slots, place, kClose, safe_dash_power(world, power), {10});
}

}  // namespace

int set_play_kicker(const WorldModel& world) {
  const TeamPoints homes = home_positions(world);
  const Vec2 ball = world.ball.position;
  int first = 0;
  int second = 0;
  const auto home_distance = [&](int unum) {
    return distance(homes[static_cast<std::size_t>(unum - 1)], ball);
  };
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const PlayerState* mate = world.teammate(unum);
    const bool self = unum == world.unum;
    const bool goalie = self ? world.goalie : mate != nullptr && mate->goalie;
    if (goalie || unum == world.our_goalie_unum) continue;
    if (first == 0 || home_distance(unum) < home_distance(first)) {
      second = first;
      first = unum;
    } else if (second == 0 || home_distance(unum) < home_distance(second)) {
      second = unum;
    }
  }
  if (second == 0 || home_distance(first) < 0.95 * home_distance(second)) return first;
  const auto real_distance = [&](int unum) {
    if (unum == world.unum) return distance(world.self.position, ball);
    const PlayerState* mate = world.teammate(unum);
    return mate != nullptr ? distance(mate->position, ball) : 1000.0;
  };
  return real_distance(second) < real_distance(first) ? second : first;
}

bool kick_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  const AngleDeg direction = kick_direction(world);
  if (go_behind_ball(c, direction)) return true;
  if (!world.self.kickable) {
    // There, and the ball is not: what we believe of its place was wrong.
    const Vec2 ball = world.ball.position;
    c.neck.kind = NeckPlan::Kind::kBall;
    if (go_to_point(world, c.slots, ball, 0.5, 30.0, {10})) return true;
    return turn_to_ball(world, c.slots) || c.slots.turn(0.0);
  }
  const bool wait = others_need_time(world) || waits_for_teammates(world);
  const int since = world.game.time.cycle - world.game.last_set_play_start;
  const bool due = since >= world.server().drop_ball_time - 5;
  c.neck.kind = NeckPlan::Kind::kScan;
  if (wait && !due) return turn_to_angle(world, c.slots, waiting_direction(world, direction));
  if (kind_of(world.game.mode) == PlayMode::kGoalKickLeft) return kick_outlet(c);
  constexpr int kPassPatience = 45;
  if (play_planned_pass(c)) return true;
  if (!due && since < kPassPatience) {
    return turn_to_angle(world, c.slots, waiting_direction(world, direction));
  }
  return kick_into_play(c);
}

}  // namespace cls::proxy
