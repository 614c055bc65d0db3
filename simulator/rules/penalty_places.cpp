// Checking and correcting places at a kick of the shoot-out.
#include "simulator/rules/penalty_places.h"

#include <cmath>

#include "simulator/rules/penalty_modes.h"
#include "simulator/rules/penalty_score.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Circle;

constexpr double kTakerDistance = 2.0;
constexpr double kGoalieTolerance = 1.5;
// The taker side's goalie waits behind the corner of the pitch next to the goal used.
constexpr Circle kGoalieWaits = {{54.5, 25.0}, 2.0};

Side taker_side(const World& world) { return world.referee.penalty.taker_side; }

Slot goalie_of(const World& world, Side side) {
  for (const Player& player : world.players) {
    if (player.enabled && player.goalie && player.side == side) return player.slot();
  }
  return kNobody;
}

Circle centre_circle(const World& world, const Player& player) {
  return {{}, soccer::kCentreCircleRadius - world.type_of(player).player_size};
}

/// Field players who are not in the centre circle.
struct Outside {
  int count = 0;
  Slot last = kNobody;
};

Outside outside(const World& world, Side side) {
  Outside result;
  for (const Player& player : world.players) {
    if (!player.enabled || player.goalie || player.side != side) continue;
    if (centre_circle(world, player).contains(player.position)) continue;
    ++result.count;
    result.last = player.slot();
  }
  return result;
}

double distance_to_ball(const World& world, const Player& player) {
  return distance(player.position, world.ball.position);
}

bool waits_beside_the_goal(const Player& goalie) {
  return std::fabs(goalie.position.x) >= soccer::kHalfLength - kGoalieTolerance &&
         std::fabs(goalie.position.y) >= soccer::kPenaltyAreaWidth / 2.0 - kGoalieTolerance;
}

// Nearest to the ball of those who have not kicked; the goalie if no other is left.
Slot next_taker(const World& world) {
  if (world.referee.penalty.last_taker != kNobody) return world.referee.penalty.last_taker;
  Slot best = kNobody;
  Slot goalie = kNobody;
  for (const Player& player : world.players) {
    if (!player.enabled || player.side != taker_side(world) || has_kicked(world, player)) continue;
    if (player.goalie) {
      goalie = player.slot();
    } else if (best == kNobody ||
               distance_to_ball(world, player) < distance_to_ball(world, world.player(best))) {
      best = player.slot();
    }
  }
  return best != kNobody ? best : goalie;
}

void bring_into(const Circle& circle, Player& player) {
  if (!circle.contains(player.position)) player.position = nearest_edge(circle, player.position);
}

bool is_taker_team_placed(const World& world) {
  const Slot goalie_slot = goalie_of(world, taker_side(world));
  if (goalie_slot == kNobody) return false;
  const Player& goalie = world.player(goalie_slot);
  const Outside others = outside(world, taker_side(world));
  Slot taker = others.last;
  if (others.count == 0) {
    if (is_setup(world.mode) && distance_to_ball(world, goalie) <= kTakerDistance) {
      taker = goalie_slot;
    }
  } else {
    if (!waits_beside_the_goal(goalie) || others.count > 1) return false;
    if (is_setup(world.mode) && distance_to_ball(world, world.player(taker)) > kTakerDistance) {
      return false;
    }
  }
  return taker == kNobody ||
         world.mode != for_side(PlayMode::kPenaltySetupLeft, taker_side(world)) ||
         !has_kicked(world, world.player(taker));
}

bool is_defending_team_placed(const World& world, Side side) {
  const Slot goalie_slot = goalie_of(world, side);
  if (goalie_slot == kNobody) return false;
  const Vec2 goalie = world.player(goalie_slot).position;
  const soccer::ServerParams& server = world.params();
  if (!is_taken(world.mode) &&
      (std::fabs(goalie.x) < soccer::kHalfLength - server.pen_max_goalie_dist_x ||
       std::fabs(goalie.y) > server.goal_width / 2.0)) {
    return false;
  }
  return outside(world, side).count == 0;
}

void place_taker_team(World& world) {
  const Slot taker = next_taker(world);
  const Vec2 ball = world.ball.position;
  for (Player& player : world.players) {
    if (!player.enabled || player.side != taker_side(world)) continue;
    if (player.slot() == taker) {
      if (!is_taken(world.mode)) bring_into({ball, kTakerDistance}, player);
    } else if (player.goalie) {
      Circle place = kGoalieWaits;
      place.centre.x *= -sign(world.referee.penalty.goal_side);
      if (player.position.y <= 0.0) place.centre.y = -place.centre.y;
      bring_into(place, player);
    } else {
      bring_into(centre_circle(world, player), player);
    }
  }
}

// All but the taker's team.
void place_others(World& world) {
  const soccer::ServerParams& server = world.params();
  const double end = world.referee.penalty.goal_side == Side::kLeft ? -1.0 : 1.0;
  const double limit = soccer::kHalfLength - server.pen_max_goalie_dist_x;
  for (Player& player : world.players) {
    if (!player.enabled || player.side == taker_side(world)) continue;
    if (!player.goalie) {
      bring_into(centre_circle(world, player), player);
    } else if (!is_taken(world.mode) && player.position.x * end < limit) {
      player.position = {(limit + kGoalieTolerance) * end, 0.0};
    }
  }
}

}  // namespace

bool is_team_placed(const World& world, Side side) {
  if (is_between_kicks(world.mode)) return true;
  return side == taker_side(world) ? is_taker_team_placed(world)
                                   : is_defending_team_placed(world, side);
}

void place_team(World& world, Side side) {
  if (side == taker_side(world)) {
    place_taker_team(world);
  } else {
    place_others(world);
  }
}

}  // namespace cls::simulator
