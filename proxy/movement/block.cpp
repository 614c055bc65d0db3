// The race between a dribbler and those in front of him.
#include "proxy/movement/block.h"

#include <algorithm>
#include <cmath>

#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

constexpr int kLongest = 30;           ///< cycles
constexpr double kDribbleSpeed = 0.7;  ///< metres a cycle
constexpr double kInTheWay = 0.7;      ///< metres beside the way that still stop him

/// Cycles until the opponents have the ball, and where that is; nothing when it is not theirs.
struct Possession {
  int cycles = 0;
  Vec2 ball;
};

std::optional<Possession> possession_of_opponents(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  const int ours = std::min(table.best_self_steps(), table.first_teammate_steps);
  if (world.kickable_teammate() || world.self.kickable) return std::nullopt;
  if (world.kickable_opponent()) return Possession{0, world.ball.position};
  if (table.first_opponent_steps >= std::min(ours, 50)) return std::nullopt;
  return Possession{table.first_opponent_steps, ball_after(world, table.first_opponent_steps)};
}

/// Towards our goal, on the wing straight on for a while.
Vec2 dribble_direction(Vec2 ball) {
  const Vec2 goal{-soccer::kHalfLength, std::clamp(ball.y, -5.0, 5.0)};
  Vec2 aim = goal;
  if (ball.x > -30.0) aim = {ball.x - 20.0, 0.85 * ball.y};
  return soccer::with_length(aim - ball, 1.0);
}

/// First cycle in which somebody of ours, starting there, is in the way; kLongest + 1: never.
int cycles_to_block(const WorldModel& world, const soccer::PlayerType& type, Vec2 from,
                    soccer::AngleDeg body, bool body_known, const Possession& theirs) {
  const Vec2 step = dribble_direction(theirs.ball) * kDribbleSpeed;
  for (int cycle = 1; cycle <= kLongest; ++cycle) {
    const Vec2 there = theirs.ball + step * std::max(0, cycle - theirs.cycles);
    const Vec2 way = there - from;
    const double run = way.length() - kInTheWay;
    if (run <= 0.0) return cycle;
    const bool turn = body_known && (soccer::AngleDeg::of(way) - body).abs() > 25.0;
    if (cycles_to_run(world.server(), type, run) + (turn ? 1 : 0) <= cycle) return cycle;
  }
  return kLongest + 1;
}

}  // namespace

std::optional<Vec2> block_point(const WorldModel& world) {
  const std::optional<Possession> theirs = possession_of_opponents(world);
  if (!theirs) return std::nullopt;
  const Vec2 here = self_after(world, 1);
  const int own = cycles_to_block(world, world.self_type(), here, world.self.body, true, *theirs);
  if (own > kLongest) return std::nullopt;
  for (const PlayerState& mate : world.teammates) {
    if (mate.goalie || mate.ghost() || mate.pos_count > 10 || mate.tackling) continue;
    const Vec2 from = mate.position + (mate.velocity_valid() ? mate.velocity : Vec2{});
    const int other =
        cycles_to_block(world, world.type_of(mate), from, mate.body, mate.body_count <= 2, *theirs);
    const bool by_number = other == own && mate.unum != 0 && mate.unum < world.unum;
    if (other < own || by_number) return std::nullopt;
  }
  const Vec2 step = dribble_direction(theirs->ball) * kDribbleSpeed;
  return theirs->ball + step * std::max(0, own - theirs->cycles);
}

}  // namespace cls::proxy
