// Kick, catch and tackle as the server judges them, with margins for what is only believed.
#include "proxy/estimates/chances.h"

#include <algorithm>
#include <cmath>

#include "soccer/math.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;
using soccer::Vec2;

constexpr double kLeastKickRate = 0.0001;

/// The older the sight of the ball, the surer it must look to count as kickable.
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
  return std::max(kLeastKickRate, type.kick_power_rate * (1.0 - 0.25 * turn - 0.25 * gap));
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

/// Chance of a tackle whose chance of failure grows with this exponent.
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

double safety_dash_power(const WorldModel& world) {
  const soccer::ServerParams& server = world.server();
  const SelfState& self = world.self;
  const bool exhausted = self.capacity == 0.0;
  const double threshold = server.recover_dec_thr * server.stamina_max + 1.0;
  const double available = exhausted ? self.stamina + world.self_type().extra_stamina
                                     : std::max(0.0, self.stamina - threshold);
  return std::min(server.max_dash_power, available);
}

}  // namespace

CatchReach catch_reach(const WorldModel& world) {
  const soccer::ServerParams& server = world.server();
  const double length = server.catchable_area_l;
  const double stretch = length * (world.self_type().catchable_area_l_stretch - 1.0);
  // The rectangle is laid so that the ball comes to its long side.
  const double half_width = 0.5 * server.catchable_area_w;
  const auto diagonal = [half_width](double l) { return Vec2{l, half_width}.length(); };
  return {diagonal(length - stretch), diagonal(length + stretch)};
}

void judge_chances(WorldModel& world) {
  SelfState& self = world.self;
  const BallState& ball = world.ball;
  self.kickable = false;
  self.kick_rate = kLeastKickRate;
  self.catch_probability = self.tackle_probability = self.foul_probability = 0.0;
  self.safety_dash_power = safety_dash_power(world);
  if (!ball.position_valid() || ball.ghost_count > 0) return;
  const double area = world.self_type().kickable_area(world.server().ball_size);
  self.kickable = ball.dist_from_self <= area - kickable_margin(ball.seen_pos_count);
  self.kick_rate = kick_rate_now(world);
  self.catch_probability = catch_chance(world);
  self.tackle_probability = tackle_chance(world, world.server().tackle_exponent);
  self.foul_probability = tackle_chance(world, world.server().foul_exponent);
}

}  // namespace cls::proxy
