// Decides when to tackle and in which direction.
#include "player/movement/tackle.h"

#include <algorithm>
#include <cmath>

#include "player/movement/ball_race.h"
#include "player/world/motion.h"
#include "player/world/planner_parameters.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

/// Ball velocity after a successful tackle in `direction`, degrees relative to the body.
Vec2 tackled_velocity(const WorldModel& world, double direction) {
  const auto& server = world.server();
  const double ball = (world.ball.angle_from_self - world.self.body).abs();
  const double share = 1.0 - std::fabs(soccer::math::normalize_degrees(direction)) / 180.0;
  const double power = server.max_back_tackle_power +
                       (server.max_tackle_power - server.max_back_tackle_power) * share;

  const double push = power * server.tackle_power_rate * (1.0 - 0.5 * ball / 180.0);
  const Vec2 velocity =
      world.ball.velocity +
      speed_limited(soccer::polar(push, world.self.body + direction), server.ball_accel_max);
  return speed_limited(velocity, server.ball_speed_max);
}

/// True if the rolling ball crosses the goal line x = `x` between the posts.
bool rolls_into_goal(const WorldModel& world, Vec2 velocity, double x) {
  if (velocity.x * x <= 0.0) return false;
  const double share = (x - world.ball.position.x) / velocity.x;
  const double roll = 1.0 / (1.0 - world.server().ball_decay);
  if (share < 0.0 || share > roll) return false;
  const double y = world.ball.position.y + velocity.y * share;
  return std::fabs(y) < world.server().goal_width / 2.0 + 1.0;
}

double outcome(const WorldModel& world, const BallRace& race, Vec2 velocity) {
  if (rolls_into_goal(world, velocity, soccer::kHalfLength)) return 1e6;
  if (rolls_into_goal(world, velocity, -soccer::kHalfLength)) return -1e6;

  const Vec2 there = coast(world.ball.position, velocity, world.server().ball_decay, 5);
  const double from_goal = distance(there, {-soccer::kHalfLength, 0.0});
  const double outwards = std::fabs(there.y) - std::fabs(world.ball.position.y);
  constexpr double kPossession = 6.0;  // points per cycle of the lead
  constexpr int kMaxLead = 5;

  const RaceResult result = race.run(velocity);
  const int lead = std::clamp(result.theirs - result.ours, -kMaxLead, kMaxLead);
  return 2.0 * from_goal + outwards + kPossession * lead;
}

double best_direction(const WorldModel& world, bool foul) {
  constexpr int kDirections = 40;
  const BallRace race(world, foul);
  double best = 0.0;
  double best_value = -1e9;

  for (int i = 0; i < kDirections; ++i) {
    const double direction = 360.0 * i / kDirections - 180.0;
    const double value = outcome(world, race, tackled_velocity(world, direction));
    if (value > best_value) {
      best_value = value;
      best = direction;
    }
  }

  return best;
}

bool is_tackle_needed(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  if (world.kickable_opponent()) return true;
  if (rolls_into_goal(world, world.ball.velocity, -soccer::kHalfLength)) return true;

  const int self = table.best_self_steps();
  const int our_cycles = std::min(self, table.first_teammate_steps);
  if (table.first_opponent_steps < our_cycles - 3) return true;
  const Vec2 goal{soccer::kHalfLength, 0.0};
  const bool facing = (AngleDeg::of(goal - world.self.position) - world.self.body).abs() < 45.0;
  return self >= 5 && facing && distance(world.ball.position, goal) < 10.0;
}

bool in_own_area(const WorldModel& world) {
  const Vec2 ball = world.ball.position;
  return ball.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength + 0.5 &&
         std::fabs(ball.y) < soccer::kPenaltyAreaWidth / 2.0 + 0.5;
}

/// True if the tackle would hit the back of an opponent with the ball who faces away from our goal:
/// the referee calls about half of these tackles as fouls. Opponents who face our goal are tackled
/// nevertheless.
bool hits_back(const WorldModel& world) {
  const Vec2 to_ball = world.ball.position - world.self.position;

  for (const PlayerState& opponent : world.opponents) {
    const soccer::PlayerType& type = world.type_of(opponent);
    constexpr double kSightError = 0.15;
    const bool has_ball =
        opponent.dist_from_ball < type.kickable_area(world.server().ball_size) + kSightError;
    if (!has_ball || opponent.ghost() || opponent.body_count > 1) continue;

    const Vec2 relative = opponent.position - world.self.position;
    if (relative.length() > to_ball.length() + kSightError || dot(relative, to_ball) < 0.0)
      continue;
    const double beside = std::fabs(cross(to_ball, relative)) / std::max(0.01, to_ball.length());
    if (beside > type.player_size + world.self_type().player_size + kSightError) continue;

    const AngleDeg to_goal = AngleDeg::of(Vec2{-soccer::kHalfLength, 0.0} - opponent.position);
    const bool harmless = (opponent.body - to_goal).abs() > world.planner->area_back_angle;
    if (harmless && (opponent.body - AngleDeg::of(to_ball)).abs() < 90.0) return true;
  }

  return false;
}

/// True if an intentional foul pays: not near our goal, and not with a card.
bool should_foul(const WorldModel& world) {
  return world.planner->fouls != 0 && world.self.card == soccer::Card::kNone &&
         !in_own_area(world) && world.self.foul_probability > world.self.tackle_probability;
}

}  // namespace

bool tackle_to_point(const WorldModel& world, CommandSlots& slots, Vec2 target,
                     double min_probability, double min_speed) {
  if (world.self.tackle_probability < min_probability) return false;

  const AngleDeg desired = AngleDeg::of(target - world.ball.position);
  const double direction = (desired - world.self.body).degrees();
  const Vec2 velocity = tackled_velocity(world, direction);
  if (velocity.length() < min_speed || (AngleDeg::of(velocity) - desired).abs() > 90.0) {
    return false;
  }

  return slots.tackle(direction);
}

bool basic_tackle(const WorldModel& world, CommandSlots& slots, double min_probability) {
  const bool foul = should_foul(world);
  const double probability = foul ? world.self.foul_probability : world.self.tackle_probability;
  if (probability < min_probability || probability <= 0.0 || !is_tackle_needed(world)) return false;
  // An indirect free kick in front of our goal is worse than their current possession.
  const bool goal_in_danger = rolls_into_goal(world, world.ball.velocity, -soccer::kHalfLength);
  if (in_own_area(world) && !goal_in_danger && hits_back(world)) return false;
  return slots.tackle(best_direction(world, foul), foul);
}

}  // namespace cls::player
