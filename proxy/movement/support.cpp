// Places around the own one, each judged by the pass that could go there.
#include "proxy/movement/support.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

constexpr double kFirstX = 10.0;  ///< of the ball, from where on attackers leave their places
constexpr double kFarthest = 28.0;
constexpr std::array<double, 4> kRings{0.0, 2.5, 5.0, 7.5};
constexpr int kDirections = 12;
constexpr int kStale = 10;

bool ours_to_pass(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  return world.kickable_teammate() ||
         (table.first_teammate_steps <= 4 &&
          table.first_teammate_steps <
              std::min(table.first_opponent_steps, table.best_self_steps()));
}

/// Metres by which the nearest opponent misses a pass to the point, as fast as passes are; at most
/// `most`.
double lane_margin(const WorldModel& world, Vec2 ball, Vec2 point, double most) {
  constexpr double kPassSpeed = 1.9;
  constexpr double kReaction = 1.5;  // cycles
  constexpr double kRun = 0.7;       // metres a cycle
  const Vec2 way = point - ball;
  const double length = std::max(0.1, way.length());
  double margin = most;
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.pos_count > kStale || opponent.ghost()) continue;
    const Vec2 relative = opponent.position - ball;
    const double along = std::clamp(dot(relative, way) / length, 0.0, length);
    if (along < 0.5) continue;  // he is behind the ball
    const double beside = (relative - way * (along / length)).length();
    const double run = kRun * std::max(0.0, along / kPassSpeed - kReaction);
    margin = std::min(margin, beside - 1.0 - run);
  }
  return margin;
}

double room_at(const WorldModel& world, Vec2 point, double most) {
  double room = most;
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.pos_count > kStale || opponent.ghost()) continue;
    room = std::min(room, distance(opponent.position, point));
  }
  return room;
}

/// How much a place is already somebody else's.
double crowding(const WorldModel& world, const TeamPoints& home, Vec2 point) {
  constexpr double kApart = 7.0;
  double least = kApart;
  for (int unum = 2; unum <= soccer::kPlayersPerTeam; ++unum) {
    if (unum == world.unum) continue;
    least = std::min(least, distance(home[static_cast<std::size_t>(unum - 1)], point));
  }
  return kApart - least;
}

double worth(const WorldModel& world, const TeamPoints& home, Vec2 ball, Vec2 own, Vec2 point) {
  const Vec2 goal{soccer::kHalfLength, 0.0};
  return 1.6 * lane_margin(world, ball, point, 2.5) + 0.5 * room_at(world, point, 5.0) -
         0.25 * distance(point, goal) - 0.25 * distance(point, own) -
         0.15 * distance(point, world.self.position) - 0.5 * crowding(world, home, point);
}

}  // namespace

std::optional<Vec2> support_point(const WorldModel& world, const TeamPoints& home) {
  const Vec2 ball = first_reach_point(world);
  const Vec2 own = home[static_cast<std::size_t>(world.unum - 1)];
  const double away = distance(own, ball);
  if (world.goalie || !ours_to_pass(world) || ball.x < kFirstX) return std::nullopt;
  if (away > kFarthest || own.x < ball.x - 12.0) return std::nullopt;
  if (world.self.stamina < 0.55 * world.server().stamina_max) return std::nullopt;
  Vec2 best = own;
  double best_worth = -1e9;
  for (const double ring : kRings) {
    for (int i = 0; i < (ring > 0.0 ? kDirections : 1); ++i) {
      Vec2 point = own + soccer::polar_degrees(ring, 360.0 * i / kDirections);
      point.x = std::min({point.x, world.lines.offside - 0.7, soccer::kHalfLength - 1.5});
      point.y = std::clamp(point.y, -soccer::kHalfWidth + 1.5, soccer::kHalfWidth - 1.5);
      if (distance(point, ball) < 5.0) continue;
      const double value = worth(world, home, ball, own, point);
      if (value <= best_worth) continue;
      best_worth = value;
      best = point;
    }
  }
  return best;
}

}  // namespace cls::proxy
