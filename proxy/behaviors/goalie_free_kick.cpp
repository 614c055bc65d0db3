// Wait, move, kick.
#include "proxy/behaviors/goalie_free_kick.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proxy/behaviors/goalie.h"
#include "proxy/behaviors/kick_into_play.h"
#include "proxy/looking/looking.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

bool holds_caught_ball(const WorldModel& world) {
  return world.game.goalie_catch && world.game.mode_side() == world.our_side;
}

/// The place with fewest opponents around.
Vec2 roomiest_place(const WorldModel& world) {
  static constexpr std::array<Vec2, 3> kPlaces{{{-43.0, 10.0}, {-43.0, -10.0}, {-43.0, 0.0}}};
  Vec2 best = kPlaces[0];
  double best_room = -1.0;
  for (const Vec2 place : kPlaces) {
    double room = 100.0;
    for (const PlayerState& opponent : world.opponents) {
      if (opponent.position_valid()) room = std::min(room, distance(opponent.position, place));
    }
    if (room > best_room) {
      best_room = room;
      best = place;
    }
  }
  return best;
}

bool wait(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kScan;
  const WorldModel& world = c.world;
  const Vec2 upfield{0.0, 0.0};
  return body_neck_to_point(world, c.memory.sight, c.slots, upfield);
}

}  // namespace

bool goalie_free_kick(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.self.frozen()) return false;
  GoalieKickMemory& memory = c.memory.goalie_kick;
  if (!holds_caught_ball(world)) {
    memory = {};
    return goalie_move(c);
  }
  // After a move the ball is believed elsewhere for a while. It is in our hands all the same, and
  // would come along into our goal.
  if (!world.self.kickable) return neck_body_to_ball(world, c.memory.sight, c.slots, 0.0);
  const int since = world.game.time.cycle - std::max(0, world.game.caught_time);
  constexpr int kSettle = 3;
  constexpr int kPatience = 50;  // the others run to their places meanwhile
  constexpr int kAfterMove = 5;
  const int limit = world.server().drop_ball_time - 10;
  if (since < kSettle) return wait(c);
  if (!memory.moved) {
    const bool rested = since >= std::min(kPatience, limit - kAfterMove);
    if (!rested) return wait(c);
    memory.moved = true;
    memory.move_cycle = world.game.time.cycle;
    c.neck.kind = NeckPlan::Kind::kScan;
    if (c.slots.move(roomiest_place(world))) return true;
  }
  const bool seen = world.game.see_time == world.game.time.cycle;
  const bool due = since >= limit;
  if (!due && (world.game.time.cycle - memory.move_cycle < kAfterMove || !seen)) return wait(c);
  if (play_planned_pass(c)) return true;
  if (!due && world.game.time.cycle - memory.move_cycle < 3 * kAfterMove) return wait(c);
  return kick_outlet(c);
}

}  // namespace cls::proxy
