// Who does what while the ball is dead.
#include "proxy/behaviors/set_play.h"

#include <algorithm>
#include <cmath>

#include "proxy/behaviors/basic_move.h"
#include "proxy/behaviors/goalie.h"
#include "proxy/behaviors/goalie_free_kick.h"
#include "proxy/behaviors/set_play_kicker.h"
#include "proxy/movement/home_positions.h"
#include "proxy/movement/intercept.h"
#include "proxy/movement/mark.h"
#include "proxy/movement/movement.h"
#include "proxy/world/motion.h"
#include "soccer/mode_kind.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;
using soccer::Vec2;

double running_power(ActionContext& c) {
  const WorldModel& world = c.world;
  const double rest = std::max(0.0, world.self_type().stamina_inc_max * world.self.recovery);
  const double half = 0.5 * world.server().stamina_max;
  return world.self.stamina > half ? std::min(world.server().max_dash_power, 2.0 * rest) : rest;
}

/// Runs to the place, faces the ball there.
bool take_place(ActionContext& c, Vec2 place) {
  const WorldModel& world = c.world;
  const double threshold = std::clamp(0.07 * world.ball.dist_from_self, 0.7, 2.0);
  c.neck.kind = NeckPlan::Kind::kBallOrScan;
  const double power = safe_dash_power(world, running_power(c));
  if (go_to_point(world, c.slots, place, threshold, power)) return true;
  turn_to_ball(world, c.slots);
  return c.slots.has_body();
}

/// Outside the circle around the ball that opponents of the kicker must keep clear of.
Vec2 keep_off(Vec2 place, Vec2 ball) {
  constexpr double kKeepOff = 11.0;
  const Vec2 relative = place - ball;
  if (relative.length() >= kKeepOff) return place;
  // Goalwards of the ball, so that nobody ends up behind it.
  Vec2 way = relative;
  way.x = std::min(way.x, -0.5 * std::fabs(way.y) - 0.1);
  Vec2 out = ball + soccer::with_length(way, kKeepOff);
  if (std::fabs(out.y) > soccer::kHalfWidth) {
    out.y = std::copysign(soccer::kHalfWidth, out.y);
    out.x = ball.x -
            std::sqrt(std::max(0.0, kKeepOff * kKeepOff - (out.y - ball.y) * (out.y - ball.y)));
  }
  // Behind the goal line there is no room: onto it.
  out.x = std::max(out.x, -soccer::kHalfLength + 0.5);
  return out;
}

/// The straight way would lead through the forbidden circle: by its edge instead.
Vec2 around_circle(Vec2 from, Vec2 to, Vec2 ball) {
  constexpr double kRadius = soccer::kCentreCircleRadius + 0.6;
  if (distance(from, ball) < kRadius) {
    return ball + soccer::with_length(from - ball, kRadius + 1.0);
  }
  if (distance(soccer::Segment{from, to}, ball) > kRadius) return to;
  const Vec2 way = to - from;
  const double side = cross(way, ball - from) > 0.0 ? 1.0 : -1.0;
  return ball + soccer::with_length(Vec2{way.y, -way.x} * side, kRadius + 1.5);
}

bool their_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  const TeamPoints homes = home_positions(world);
  Vec2 place = homes[static_cast<std::size_t>(world.unum - 1)];
  const PlayMode kind = kind_of(world.game.mode);
  if (kind == PlayMode::kKickOffLeft) {
    place.x = std::min(place.x, -0.5);
  } else if (kind == PlayMode::kGoalKickLeft) {
    constexpr double kOffBox = soccer::kHalfLength - soccer::kPenaltyAreaLength - 0.8;
    if (std::fabs(place.y) < soccer::kPenaltyAreaWidth / 2.0 + 0.8) {
      place.x = std::min(place.x, kOffBox);
    }
    // Once kicked it may be ours before it leaves their area.
    const InterceptTable& table = world.intercept;
    const bool rolls = world.ball.velocity.length() > 0.2;
    const Vec2 meeting = ball_after(world, std::min(table.best_self_steps(), 50));
    if (rolls && meeting.x < kOffBox && table.best_self_steps() < table.first_teammate_steps) {
      return intercept(world, c.slots, true, {soccer::kHalfLength, 0.0});
    }
    return take_place(c, place);
  } else if (const auto mark = mark_point(world, homes, kMarkAtDeadBall)) {
    place = *mark;
  }
  place = keep_off(place, world.ball.position);
  return take_place(c, around_circle(world.self.position, place, world.ball.position));
}

/// A step aside now and then shakes off a marker.
Vec2 shake_off(const WorldModel& world, Vec2 place) {
  const bool marked =
      std::any_of(world.opponents.begin(), world.opponents.end(), [&](const PlayerState& opponent) {
        return opponent.pos_count <= 5 && distance(opponent.position, world.self.position) < 3.0;
      });
  const int phase = world.game.time.cycle / 20 % 2;
  if (!marked || world.self.stamina < 0.6 * world.server().stamina_max) return place;
  place.y += phase == 0 ? 3.0 : -3.0;
  place.y = std::clamp(place.y, -soccer::kHalfWidth + 1.0, soccer::kHalfWidth - 1.0);
  return place;
}

/// Our kicked ball counts as dead until it has left the area, or the referee has called: it is to
/// be fetched all the same. Neither the goalie nor who kicked it is the one.
bool fetch_kicked_ball(ActionContext& c) {
  const WorldModel& world = c.world;
  constexpr double kRolls = 0.3;
  const InterceptTable& table = world.intercept;
  const bool rolls = world.ball.vel_count <= 1 && world.ball.velocity.length() > kRolls;
  const bool own_kick =
      world.last_kick.side == world.our_side && world.last_kick.unum == world.unum;
  if (own_kick || !rolls || world.self.kickable || table.best_self_steps() >= kNever) return false;
  const PlayerState* first = world.player_by_id(table.first_teammate_id);
  const bool goalie_first = first != nullptr && first->goalie;
  const int others = goalie_first ? table.second_teammate_steps : table.first_teammate_steps;
  if (table.best_self_steps() > others) return false;
  c.neck.kind = NeckPlan::Kind::kBall;
  return intercept(world, c.slots, true, {soccer::kHalfLength, 0.0});
}

bool our_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  if (set_play_kicker(world) == world.unum) return kick_set_play(c);
  const PlayMode kind = kind_of(world.game.mode);
  Vec2 place = own_home_position(world);
  if (kind == PlayMode::kKickOffLeft) {
    place.x = std::min(place.x, -0.5);
  } else {
    place = shake_off(world, place);
    const bool no_offside = kind == PlayMode::kKickInLeft || kind == PlayMode::kCornerKickLeft ||
                            kind == PlayMode::kGoalKickLeft;
    if (!no_offside) place.x = std::min(place.x, world.lines.offside - 0.5);
  }
  // Ask the kicker for patience while on the way from afar, or out of breath.
  const int since = world.game.time.cycle - world.game.last_set_play_start;
  const bool far = distance(world.self.position, place) > 12.0;
  const bool tired = world.self.stamina < 0.45 * world.server().stamina_max;
  constexpr int kAskUntil = 50;
  if ((far || tired) && since < kAskUntil) c.slots.say("w");
  return take_place(c, place);
}

bool goalie_in_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  const bool ours = is_set_play_of(world.game, world.our_side);
  if (world.game.goalie_catch && ours) return goalie_free_kick(c);
  return goalie_move(c);
}

}  // namespace

bool play_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.self.frozen()) return false;
  if (world.goalie) return goalie_in_set_play(c);
  const bool ours = is_set_play_of(world.game, world.our_side);
  if (ours && fetch_kicked_ball(c)) return true;
  if (ours && world.game.goalie_catch) return take_place(c, own_home_position(world));
  if (ours && kind_of(world.game.mode) == PlayMode::kGoalKickLeft) {
    return set_play_kicker(world) == world.unum ? kick_set_play(c)
                                                : take_place(c, own_home_position(world));
  }
  if (ours) return our_set_play(c);
  if (is_set_play_of(world.game, world.their_side())) return their_set_play(c);
  return basic_move(world, c.slots, c.neck, c.memory.recovering);
}

}  // namespace cls::proxy
