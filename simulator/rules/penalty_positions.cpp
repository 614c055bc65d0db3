// Checks and corrects the positions of players at a kick of the shoot-out.
#include <cmath>

#include "simulator/referee/modes.h"
#include "simulator/rules/penalty.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Circle;

constexpr double kTakerDistance = 2.0;
constexpr double kGoalieTolerance = 1.5;
// Waiting area of the taker side's goalie, outside the pitch beside the goal in use.
constexpr Circle kGoalieWaitingArea = {{54.5, 25.0}, 2.0};

Side taker_side(const World& world) { return world.referee.penalty.taker_side; }

Slot goalie_of(const World& world, Side side) {
  for (const Player& player : world.players) {
    if (player.enabled && player.goalie && player.side == side) return player.slot();
  }
  return kNoPlayer;
}

Circle center_circle(const World& world, const Player& player) {
  return {{}, soccer::kCenterCircleRadius - world.type_of(player).player_size};
}

/// Field players outside the center circle.
struct OutsidePlayers {
  int count = 0;
  Slot last = kNoPlayer;
};

OutsidePlayers outside(const World& world, Side side) {
  OutsidePlayers result;
  for (const Player& player : world.players) {
    if (!player.enabled || player.goalie || player.side != side) continue;
    if (center_circle(world, player).contains(player.position)) continue;

    ++result.count;
    result.last = player.slot();
  }
  return result;
}

double distance_to_ball(const World& world, const Player& player) {
  return distance(player.position, world.ball.position);
}

bool waits_beside_goal(const Player& goalie) {
  return std::fabs(goalie.position.x) >= soccer::kHalfLength - kGoalieTolerance &&
         std::fabs(goalie.position.y) >= soccer::kPenaltyAreaWidth / 2.0 - kGoalieTolerance;
}

// Closest to the ball of the players that have not kicked yet; the goalie comes last.
Slot next_taker(const World& world) {
  if (world.referee.penalty.last_taker != kNoPlayer) return world.referee.penalty.last_taker;

  Slot best = kNoPlayer;
  Slot goalie = kNoPlayer;
  for (const Player& player : world.players) {
    if (!player.enabled || player.side != taker_side(world) || has_kicked(world, player)) continue;
    if (player.goalie) {
      goalie = player.slot();
    } else if (best == kNoPlayer ||
               distance_to_ball(world, player) < distance_to_ball(world, world.player(best))) {
      best = player.slot();
    }
  }

  return best != kNoPlayer ? best : goalie;
}

void move_into(const Circle& circle, Player& player) {
  if (!circle.contains(player.position)) player.position = nearest_edge(circle, player.position);
}

bool is_taker_team_placed(const World& world) {
  const Slot goalie_slot = goalie_of(world, taker_side(world));
  if (goalie_slot == kNoPlayer) return false;

  const Player& goalie = world.player(goalie_slot);
  const OutsidePlayers others = outside(world, taker_side(world));
  Slot taker = others.last;

  if (others.count == 0) {
    if (is_penalty_setup(world.mode) && distance_to_ball(world, goalie) <= kTakerDistance) {
      taker = goalie_slot;
    }
  } else {
    if (!waits_beside_goal(goalie) || others.count > 1) return false;
    if (is_penalty_setup(world.mode) &&
        distance_to_ball(world, world.player(taker)) > kTakerDistance) {
      return false;
    }
  }

  return taker == kNoPlayer ||
         world.mode != for_side(PlayMode::kPenaltySetupLeft, taker_side(world)) ||
         !has_kicked(world, world.player(taker));
}

bool is_defending_team_placed(const World& world, Side side) {
  const Slot goalie_slot = goalie_of(world, side);
  if (goalie_slot == kNoPlayer) return false;

  const Vec2 goalie = world.player(goalie_slot).position;
  const soccer::ServerParams& server = world.params();

  if (!is_penalty_taken(world.mode) &&
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
      if (!is_penalty_taken(world.mode)) move_into({ball, kTakerDistance}, player);
    } else if (player.goalie) {
      Circle area = kGoalieWaitingArea;
      area.center.x *= -sign(world.referee.penalty.goal_side);
      if (player.position.y <= 0.0) area.center.y = -area.center.y;
      move_into(area, player);
    } else {
      move_into(center_circle(world, player), player);
    }
  }
}

void place_defending_team(World& world) {
  const soccer::ServerParams& server = world.params();
  const double end = world.referee.penalty.goal_side == Side::kLeft ? -1.0 : 1.0;
  const double limit = soccer::kHalfLength - server.pen_max_goalie_dist_x;

  for (Player& player : world.players) {
    if (!player.enabled || player.side == taker_side(world)) continue;

    if (!player.goalie) {
      move_into(center_circle(world, player), player);
    } else if (!is_penalty_taken(world.mode) && player.position.x * end < limit) {
      player.position = {(limit + kGoalieTolerance) * end, 0.0};
    }
  }
}

}  // namespace

bool is_team_placed(const World& world, Side side) {
  if (is_between_penalties(world.mode)) return true;
  return side == taker_side(world) ? is_taker_team_placed(world)
                                   : is_defending_team_placed(world, side);
}

void place_team(World& world, Side side) {
  if (side == taker_side(world)) {
    place_taker_team(world);
  } else {
    place_defending_team(world);
  }
}

}  // namespace cls::simulator
