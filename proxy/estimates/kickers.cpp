// Players within reach of the ball.
#include "proxy/estimates/kickers.h"

#include <algorithm>

namespace cls::proxy {
namespace {

double kickable_area(const WorldModel& world, const PlayerState& player) {
  return world.type_of(player).kickable_area(world.server().ball_size);
}

const PlayerState* kicking_player(const PlayerList& list) {
  const PlayerState* found =
      std::find_if(list.begin(), list.end(), [](const PlayerState& p) { return p.kicking; });
  return found == list.end() ? nullptr : found;
}

}  // namespace

void find_last_kick(WorldModel& world) {
  if (world.self.kicked) {
    world.last_kick = {world.our_side, world.unum};
    return;
  }
  const PlayerState* mate = kicking_player(world.teammates);
  const PlayerState* opponent = kicking_player(world.opponents);
  if (mate != nullptr && opponent != nullptr) {
    world.last_kick = {};
  } else if (mate != nullptr || opponent != nullptr) {
    const PlayerState& kicker = mate != nullptr ? *mate : *opponent;
    world.last_kick = {kicker.side, kicker.unum};
  } else if (world.ball_tracker.pushed) {
    // Nobody was seen doing it: whoever had the ball before, if that is clear.
    const PlayerState* ours = world.player_by_id(world.kickable_teammate_id);
    const PlayerState* theirs = world.player_by_id(world.kickable_opponent_id);
    if (ours != nullptr && theirs == nullptr) world.last_kick = {ours->side, ours->unum};
    if (theirs != nullptr && ours == nullptr) world.last_kick = {theirs->side, theirs->unum};
    if (theirs != nullptr && ours != nullptr) world.last_kick = {};
  }
}

void find_kickers(WorldModel& world) {
  world.kickable_teammate_id = world.kickable_opponent_id = 0;
  const BallState& ball = world.ball;
  if (!ball.position_valid()) return;
  double nearest = kNever;
  for (const PlayerState& mate : world.teammates) {
    if (mate.ghost() || mate.tackling || mate.pos_count > ball.pos_count) continue;
    if (mate.dist_from_ball >= kickable_area(world, mate) || mate.dist_from_ball >= nearest)
      continue;
    nearest = mate.dist_from_ball;
    world.kickable_teammate_id = mate.id;
  }
  constexpr int kOldest = 10;
  nearest = kNever;
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.ghost() || opponent.tackling || opponent.pos_count >= kOldest) continue;
    const double doubt = std::min(0.5, 0.02 * (opponent.dist_from_self + ball.dist_from_self));
    if (opponent.dist_from_ball >= kickable_area(world, opponent) + doubt) continue;
    if (opponent.dist_from_ball >= nearest) continue;
    nearest = opponent.dist_from_ball;
    world.kickable_opponent_id = opponent.id;
  }
}

}  // namespace cls::proxy
