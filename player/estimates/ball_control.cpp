// Computes kickable flags and the probabilities of catch, tackle and foul by the server's rules,
// with margins for estimation errors.
#include "player/estimates/estimates.h"

#include <algorithm>
#include <cmath>

#include "player/world/candidates.h"
#include "player/world/motion.h"

namespace cls::player {
namespace {

constexpr double kMinKickRate = 0.0001;

/// Safety margin in meters: grows with the age of the ball observation.
double kickable_margin(int seen_count) {
  if (seen_count == 0) return 0.055;
  return seen_count == 1 ? 0.155 : 0.255;
}

double kick_rate_now(const WorldModel& world) {
  const BallState& ball = world.ball;
  const soccer::PlayerType& type = world.self_type();
  const double turn = (ball.angle_from_self - world.self.body).abs() / 180.0;
  const double gap =
      (ball.dist_from_self - world.server().ball_size - type.player_size) / type.kickable_margin;
  return std::max(kMinKickRate, type.kick_power_rate * (1.0 - 0.25 * turn - 0.25 * gap));
}

double catch_chance(const WorldModel& world) {
  if (world.self.catch_ban > 0) return 0.0;
  constexpr double kMargin = 0.055;

  const double distance = world.ball.dist_from_self + kMargin;
  const CatchReach reach = catch_reach(world);
  const double best = world.server().catch_probability;

  if (distance <= reach.sure) return best;
  if (distance >= reach.farthest) return 0.0;
  return best * (1.0 - (distance - reach.sure) / (reach.farthest - reach.sure));
}

/// Success probability of a tackle or foul; `exponent` of the failure terms.
double tackle_chance(const WorldModel& world, double exponent) {
  const soccer::ServerParams& server = world.server();
  const Vec2 ball =
      soccer::rotated_degrees(world.ball.relative_position, -world.self.body.degrees());
  const double reach = ball.x > 0.0 ? server.tackle_dist : server.tackle_back_dist;
  if (reach <= 1e-5) return 0.0;

  const double along = std::fabs(ball.x) / reach;
  const double across = std::fabs(ball.y) / server.tackle_width;
  if (along >= 1.0 || across >= 1.0) return 0.0;
  return std::clamp(1.0 - math::pow(along, exponent) - math::pow(across, exponent), 0.0, 1.0);
}

double kickable_area(const WorldModel& world, const PlayerState& player) {
  return world.type_of(player).kickable_area(world.server().ball_size);
}

const PlayerState* kicking_player(const PlayerList& list) {
  const PlayerState* found = std::ranges::find_if(list, &PlayerState::kicking);
  return found == list.end() ? nullptr : found;
}

}  // namespace

CatchReach catch_reach(const WorldModel& world) {
  const soccer::ServerParams& server = world.server();
  const double length = server.catchable_area_l;
  const double stretch = length * (world.self_type().catchable_area_l_stretch - 1.0);
  // The catch rectangle is aimed so that its corner points at the ball.
  const double half_width = 0.5 * server.catchable_area_w;
  const auto diagonal = [half_width](double l) { return Vec2{l, half_width}.length(); };
  return {diagonal(length - stretch), diagonal(length + stretch)};
}

void update_action_probabilities(WorldModel& world) {
  SelfState& self = world.self;
  const BallState& ball = world.ball;
  self.kickable = false;
  self.kick_rate = kMinKickRate;
  self.catch_probability = self.tackle_probability = self.foul_probability = 0.0;
  self.safety_dash_power = safe_dash_power(world, world.server().max_dash_power);

  if (!ball.position_valid() || ball.ghost_count > 0) return;
  const double area = world.self_type().kickable_area(world.server().ball_size);
  self.kickable = ball.dist_from_self <= area - kickable_margin(ball.seen_pos_count);
  self.kick_rate = kick_rate_now(world);
  self.catch_probability = catch_chance(world);
  self.tackle_probability = tackle_chance(world, world.server().tackle_exponent);
  self.foul_probability = tackle_chance(world, world.server().foul_exponent);
}

void update_last_kicker(WorldModel& world) {
  if (world.self.kicked) {
    world.last_kick = {world.our_side, world.unum};
    return;
  }

  const PlayerState* teammate = kicking_player(world.teammates);
  const PlayerState* opponent = kicking_player(world.opponents);
  if (teammate == nullptr && opponent == nullptr && world.ball_tracker.pushed) {
    // No kick was seen: the previous ball owner.
    teammate = world.player_by_id(world.kickable_teammate_id);
    opponent = world.player_by_id(world.kickable_opponent_id);
  }

  const PlayerState* kicker = teammate != nullptr ? teammate : opponent;
  if (kicker == nullptr) return;
  const bool ambiguous = teammate != nullptr && opponent != nullptr;
  world.last_kick = ambiguous ? LastKick{} : LastKick{kicker->side, kicker->unum};
}

void update_kickable_players(WorldModel& world) {
  world.kickable_teammate_id = world.kickable_opponent_id = 0;
  const BallState& ball = world.ball;
  if (!ball.position_valid()) return;

  Lowest<int> ours{kNever};
  for (const PlayerState& teammate : world.teammates) {
    if (teammate.ghost() || teammate.tackling || teammate.pos_count > ball.pos_count) continue;
    if (teammate.dist_from_ball >= kickable_area(world, teammate)) continue;
    ours.offer(teammate.dist_from_ball, teammate.id);
  }

  constexpr int kMaxAge = 10;
  Lowest<int> theirs{kNever};
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.ghost() || opponent.tackling || opponent.pos_count >= kMaxAge) continue;
    const double doubt = std::min(0.5, 0.02 * (opponent.dist_from_self + ball.dist_from_self));
    if (opponent.dist_from_ball >= kickable_area(world, opponent) + doubt) continue;
    theirs.offer(opponent.dist_from_ball, opponent.id);
  }

  world.kickable_teammate_id = ours.value;
  world.kickable_opponent_id = theirs.value;
}

}  // namespace cls::player
