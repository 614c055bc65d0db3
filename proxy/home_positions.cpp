// A 4-3-3 that moves with the ball.
#include "proxy/home_positions.h"

#include <algorithm>

#include "proxy/skills/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;
using soccer::Vec2;

/// A role: its place with the ball at the centre, how much of the ball's way it follows, and the
/// depth it stays in.
struct Role {
  Vec2 base;
  Vec2 follow;  ///< share of the ball's x and y
  double min_x;
  double max_x;
  Vec2 kick_off;
};

constexpr std::array<Role, soccer::kPlayersPerTeam> kRoles{{
    {{-49.0, 0.0}, {0.06, 0.12}, -51.0, -46.0, {-49.0, 0.0}},
    {{-17.0, -6.0}, {0.50, 0.25}, -46.0, 10.0, {-25.0, -6.0}},
    {{-17.0, 6.0}, {0.50, 0.25}, -46.0, 10.0, {-25.0, 6.0}},
    {{-15.0, -18.0}, {0.55, 0.22}, -45.0, 20.0, {-22.0, -18.0}},
    {{-15.0, 18.0}, {0.55, 0.22}, -45.0, 20.0, {-22.0, 18.0}},
    {{-6.0, 0.0}, {0.62, 0.35}, -40.0, 32.0, {-13.0, 0.0}},
    {{0.0, -11.0}, {0.65, 0.30}, -36.0, 40.0, {-10.5, -11.0}},
    {{0.0, 11.0}, {0.65, 0.30}, -36.0, 40.0, {-10.5, 11.0}},
    {{12.0, -20.0}, {0.62, 0.20}, -24.0, 46.0, {-2.0, -20.0}},
    {{12.0, 20.0}, {0.62, 0.20}, -24.0, 46.0, {-2.0, 20.0}},
    {{14.0, 0.0}, {0.62, 0.25}, -20.0, 48.0, {-0.8, -0.5}},
}};

bool before_play(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || mode == PlayMode::kGoalLeft ||
         mode == PlayMode::kGoalRight;
}

Vec2 ball_of_interest(const WorldModel& world) {
  const PlayMode mode = world.game.mode;
  const bool rolling = mode == PlayMode::kPlayOn || mode == PlayMode::kGoalKickLeft ||
                       mode == PlayMode::kGoalKickRight;
  return rolling ? first_reach_point(world) : world.ball.position;
}

/// As far forward as a player may stand without being offside.
double farthest_x(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  const int ours = std::min(table.best_self_steps(), table.first_teammate_steps);
  double line = world.lines.offside;
  if (ours < 50) line = std::max(line, ball_after(world, ours).x);
  return line - 1.0;
}

}  // namespace

std::array<Vec2, soccer::kPlayersPerTeam> home_positions(const WorldModel& world) {
  std::array<Vec2, soccer::kPlayersPerTeam> points;
  const bool waiting = before_play(world.game.mode);
  const Vec2 ball = ball_of_interest(world);
  const double max_x = farthest_x(world);
  // Steps up when the ball is ours, drops when it is theirs.
  const InterceptTable& table = world.intercept;
  const int ours = std::min(table.best_self_steps(), table.first_teammate_steps);
  const double lead = std::clamp(table.first_opponent_steps - ours, -4, 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Role& role = kRoles[i];
    if (waiting) {
      points[i] = role.kick_off;
      continue;
    }
    const double step = i == 0 ? 0.0 : lead;
    const double x =
        std::clamp(role.base.x + role.follow.x * ball.x + step, role.min_x, role.max_x);
    const double y = role.base.y + role.follow.y * ball.y;
    points[i] = {std::min(x, max_x),
                 std::clamp(y, -soccer::kHalfWidth + 1.5, soccer::kHalfWidth - 1.5)};
  }
  return points;
}

}  // namespace cls::proxy
