// Moving players out of the way.
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
// Places a player just off the circle, so that it is not found inside again.
constexpr double kGap = 1e-5;
constexpr double kShortDistance = 5.5;

/// Which players must leave which surroundings of the ball.
struct Clearance {
  Vec2 ball;
  double distance;
  bool indirect;  ///< players may stand on their goal line
  bool at_corner;
};

Clearance clearance(const World& world) {
  const PlayMode mode = world.mode;
  const bool is_short = is_either(mode, PlayMode::kIllegalDefenseLeft) ||
                        is_either(mode, PlayMode::kBackPassLeft) ||
                        (is_foul(mode) && in_penalty_area(soccer::side(mode), world.ball.position));
  Clearance result{world.ball.position, is_short ? kShortDistance : soccer::kCentreCircleRadius,
                   false, false};
  result.indirect = is_either(mode, PlayMode::kBackPassLeft) || is_foul(mode) ||
                    is_either(mode, PlayMode::kIndirectFreeKickLeft);
  result.at_corner = std::fabs(result.ball.x) > soccer::kOuterHalfLength - result.distance &&
                     std::fabs(result.ball.y) > soccer::kOuterHalfWidth - result.distance;
  return result;
}

// The place on the circle around the ball where the line at `limit` cuts it: `along` is the
// coordinate that the limit holds for, `across` the other.
void cut_at_limit(double ball_along, double ball_across, double limit, double radius, double& along,
                  double& across) {
  // Just off the circle can be beyond the limit while the circle itself is not.
  const double ratio = std::min(1.0, (limit - std::fabs(ball_along)) / radius);
  const double angle = soccer::math::acos(ratio);
  const double half = std::fabs(radius * soccer::math::sin(angle)) + kGap;
  along = std::copysign(limit, along);
  across = across < ball_across ? ball_across - half : ball_across + half;
}

Vec2 cleared_place(const Clearance& area, double radius, Vec2 from) {
  const Vec2 ball = area.ball;
  Vec2 place = nearest_edge(Circle{ball, radius + kGap}, from);
  const auto reflect = [&] { place = ball * 2.0 - place; };
  if (area.at_corner && std::fabs(place.x) > soccer::kHalfLength &&
      std::fabs(place.y) > soccer::kHalfWidth) {
    reflect();
  }
  if (area.indirect && std::fabs(place.x) > soccer::kHalfLength) {
    const double x = std::copysign(soccer::kHalfLength, place.x);
    if (place.x != ball.x) {
      place.y = ball.y + (place.y - ball.y) * (x - ball.x) / (place.x - ball.x);
    }
    place.x = x;
  }
  if (std::fabs(place.x) > soccer::kOuterHalfLength) {
    cut_at_limit(ball.x, ball.y, soccer::kOuterHalfLength, radius, place.x, place.y);
  }
  if (std::fabs(place.y) > soccer::kOuterHalfWidth) {
    cut_at_limit(ball.y, ball.x, soccer::kOuterHalfWidth, radius, place.y, place.x);
  }
  if (std::fabs(place.x) > soccer::kOuterHalfLength ||
      std::fabs(place.y) > soccer::kOuterHalfWidth) {
    reflect();
  }
  return place;
}

bool clear_once(World& world, Side side, const Clearance& area) {
  bool moved = false;
  for (Player& player : world.players) {
    if (!player.enabled || (side != Side::kNeutral && player.side != side)) continue;
    if (area.indirect && std::fabs(player.position.x) >= soccer::kHalfLength) continue;
    const double radius = area.distance + world.type_of(player).player_size;
    if (!Circle{area.ball, radius}.contains(player.position)) continue;
    player.position = cleared_place(area, radius, player.position);
    player.velocity = {};
    player.acceleration = {};
    moved = true;
  }
  return moved;
}

bool is_in_wrong_half(const Player& player) { return player.position.x * sign(player.side) > 0.0; }

Vec2 random_place_in_own_half(World& world, const Player& player) {
  const double x = world.random.placement.uniform(-soccer::kHalfLength, 0.0);
  const double y = world.random.placement.uniform(-soccer::kHalfWidth, soccer::kHalfWidth);
  const Vec2 drawn{x * sign(player.side), y};
  if (!world.forced) return drawn;
  const auto slot = static_cast<std::size_t>(player.slot());
  world.forced->placement_drawn.set(slot);
  return world.forced->placement[slot].value_or(drawn);
}

}  // namespace

void keep_players_in_field(World& world) {
  constexpr Rect kField = Rect::centred({}, soccer::kPitchLength + 2.0 * soccer::kPitchMargin,
                                        soccer::kPitchWidth + 2.0 * soccer::kPitchMargin);
  for (Player& player : world.players) {
    if (player.enabled && !kField.contains(player.position)) {
      player.position = nearest_edge(kField, player.position);
    }
  }
}

void keep_players_in_own_half(World& world) {
  const bool to_the_line =
      world.params().forbid_kick_off_offside && is_either(world.mode, PlayMode::kKickOffLeft);
  for (Player& player : world.players) {
    if (!player.enabled) continue;
    const double size = world.type_of(player).player_size;
    if (is_in_wrong_half(player)) {
      if (to_the_line) {
        player.position.x = -size * sign(player.side);
      } else {
        player.position = random_place_in_own_half(world, player);
      }
    }
    const Circle centre{{}, soccer::kCentreCircleRadius + size};
    if (player.side != world.kick_off_side && centre.contains(player.position)) {
      player.position = nearest_edge(centre, player.position);
    }
  }
}

void clear_players_from_ball(World& world, Side side, Events& events) {
  for (int round = 0; round < kMaxRounds; ++round) {
    // Resolving the collisions can move the ball and change the mode, so look anew.
    if (!clear_once(world, side, clearance(world))) return;
    resolve_collisions(world, events);
  }
}

void clear_penalty_area(World& world, Side side) {
  const double goal_line = -soccer::kHalfLength * sign(side);
  for (Player& player : world.players) {
    if (!player.enabled || player.side != opponent(side)) continue;
    const double size = world.type_of(player).player_size;
    const double depth = soccer::kPenaltyAreaLength;
    const Rect area = Rect::centred({goal_line + sign(side) * depth / 2.0, 0.0}, depth + 2.0 * size,
                                    soccer::kPenaltyAreaWidth + 2.0 * size);
    if (!area.contains(player.position)) continue;
    player.position = nearest_edge(area, player.position);
    if (std::fabs(player.position.x) >= soccer::kHalfLength) {
      player.position.x = goal_line + sign(side) * (depth + size);
    }
  }
}

}  // namespace cls::simulator
