// Moves players out of restricted areas.
#include "simulator/referee/clearing.h"

#include <algorithm>
#include <cmath>

#include "simulator/referee/areas.h"
#include "simulator/referee/collision.h"
#include "simulator/referee/modes.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Circle;
using soccer::Rect;

constexpr int kMaxRounds = 10;
// Places a player just outside the circle, so that the next round does not find it inside.
constexpr double kGap = 1e-5;
constexpr double kShortDistance = 5.5;

/// The circle around the ball that players must leave.
struct Clearance {
  Vec2 ball;
  double distance;
  bool indirect;  ///< indirect free kick: players may stand on their goal line
  bool at_corner;
};

Clearance clearance(const World& world) {
  const PlayMode mode = world.mode;
  const bool is_short = is_either(mode, PlayMode::kIllegalDefenseLeft) ||
                        is_either(mode, PlayMode::kBackPassLeft) ||
                        (is_foul(mode) && in_penalty_area(soccer::side(mode), world.ball.position));

  Clearance result{world.ball.position, is_short ? kShortDistance : soccer::kCenterCircleRadius,
                   false, false};
  result.indirect = is_either(mode, PlayMode::kBackPassLeft) || is_foul(mode) ||
                    is_either(mode, PlayMode::kIndirectFreeKickLeft);
  result.at_corner = std::fabs(result.ball.x) > soccer::kOuterHalfLength - result.distance &&
                     std::fabs(result.ball.y) > soccer::kOuterHalfWidth - result.distance;
  return result;
}

// Computes the intersection of the circle around the ball with the line at `limit`. `along` is the
// coordinate that is limited, `across` the other one.
void cut_at_limit(double ball_along, double ball_across, double limit, double radius, double& along,
                  double& across) {
  // A position just outside the circle can be beyond the limit although the circle is not.
  const double ratio = std::min(1.0, (limit - std::fabs(ball_along)) / radius);
  const double angle = soccer::math::acos(ratio);
  const double half = std::fabs(radius * soccer::math::sin(angle)) + kGap;

  along = std::copysign(limit, along);
  across = across < ball_across ? ball_across - half : ball_across + half;
}

Vec2 cleared_position(const Clearance& area, double radius, Vec2 from) {
  const Vec2 ball = area.ball;
  Vec2 position = nearest_edge(Circle{ball, radius + kGap}, from);
  const auto reflect = [&] { position = ball * 2.0 - position; };
  if (area.at_corner && std::fabs(position.x) > soccer::kHalfLength &&
      std::fabs(position.y) > soccer::kHalfWidth) {
    reflect();
  }

  if (area.indirect && std::fabs(position.x) > soccer::kHalfLength) {
    const double x = std::copysign(soccer::kHalfLength, position.x);
    if (position.x != ball.x) {
      position.y = ball.y + (position.y - ball.y) * (x - ball.x) / (position.x - ball.x);
    }
    position.x = x;
  }

  if (std::fabs(position.x) > soccer::kOuterHalfLength) {
    cut_at_limit(ball.x, ball.y, soccer::kOuterHalfLength, radius, position.x, position.y);
  }
  if (std::fabs(position.y) > soccer::kOuterHalfWidth) {
    cut_at_limit(ball.y, ball.x, soccer::kOuterHalfWidth, radius, position.y, position.x);
  }

  if (std::fabs(position.x) > soccer::kOuterHalfLength ||
      std::fabs(position.y) > soccer::kOuterHalfWidth) {
    reflect();
  }
  return position;
}

bool clear_once(World& world, Side side, const Clearance& area) {
  bool moved = false;
  for (Player& player : world.players) {
    if (!player.enabled || (side != Side::kNeutral && player.side != side)) continue;
    if (area.indirect && std::fabs(player.position.x) >= soccer::kHalfLength) continue;
    const double radius = area.distance + world.type_of(player).player_size;
    if (!Circle{area.ball, radius}.contains(player.position)) continue;

    player.position = cleared_position(area, radius, player.position);
    player.velocity = {};
    player.acceleration = {};
    moved = true;
  }

  return moved;
}

bool is_in_wrong_half(const Player& player) { return player.position.x * sign(player.side) > 0.0; }

Vec2 random_position_in_own_half(World& world, const Player& player) {
  const double x = world.random.placement.uniform(-soccer::kHalfLength, 0.0);
  const double y = world.random.placement.uniform(-soccer::kHalfWidth, soccer::kHalfWidth);

  const Vec2 drawn{x * sign(player.side), y};
  return world.overrides ? world.overrides->placement.replace(player.slot(), drawn) : drawn;
}

}  // namespace

void keep_players_in_field(World& world) {
  constexpr Rect kField = Rect::centered({}, soccer::kPitchLength + 2.0 * soccer::kPitchMargin,
                                         soccer::kPitchWidth + 2.0 * soccer::kPitchMargin);
  for (Player& player : world.players) {
    if (player.enabled && !kField.contains(player.position)) {
      player.position = nearest_edge(kField, player.position);
    }
  }
}

void keep_players_in_own_half(World& world) {
  const bool forbid_offside =
      world.params().forbid_kick_off_offside && is_either(world.mode, PlayMode::kKickOffLeft);
  for (Player& player : world.players) {
    if (!player.enabled) continue;

    const double size = world.type_of(player).player_size;
    if (is_in_wrong_half(player)) {
      if (forbid_offside) {
        player.position.x = -size * sign(player.side);
      } else {
        player.position = random_position_in_own_half(world, player);
      }
    }

    const Circle center_circle{{}, soccer::kCenterCircleRadius + size};
    if (player.side != world.kick_off_side && center_circle.contains(player.position)) {
      player.position = nearest_edge(center_circle, player.position);
    }
  }
}

void clear_players_from_ball(World& world, Side side, Events& events) {
  Bodies bodies;
  for (int round = 0; round < kMaxRounds; ++round) {
    // Resolving collisions can move the ball and change the mode: compute the clearance each round.
    if (!clear_once(world, side, clearance(world))) return;
    resolve_collisions(world, bodies, events);
  }
}

void clear_penalty_area(World& world, Side side) {
  const double goal_line = -soccer::kHalfLength * sign(side);
  for (Player& player : world.players) {
    if (!player.enabled || player.side != opponent(side)) continue;
    const double size = world.type_of(player).player_size;
    const double depth = soccer::kPenaltyAreaLength;
    const Rect area = Rect::centered({goal_line + sign(side) * depth / 2.0, 0.0},
                                     depth + 2.0 * size, soccer::kPenaltyAreaWidth + 2.0 * size);

    if (!area.contains(player.position)) continue;
    player.position = nearest_edge(area, player.position);
    if (std::fabs(player.position.x) >= soccer::kHalfLength) {
      player.position.x = goal_line + sign(side) * (depth + size);
    }
  }
}

}  // namespace cls::simulator
