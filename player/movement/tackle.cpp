// Decides when to tackle and in which direction: which team gets the ball that way.
#include "player/movement/movement.h"

#include <algorithm>
#include <cmath>

#include "base/fixed_list.h"
#include "base/index.h"
#include "player/movement/movement_parameters.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"
#include "player/world/running.h"

namespace cls::player {
namespace {

/// Cycles until a team gets the ball; as many for both if it leaves the pitch before.
struct RaceResult {
  int ours = 0;
  int theirs = 0;
};

/// The players who may run for the ball after a tackle of the agent, which lies on the ground
/// itself. The world model must outlive it.
class BallRace {
 public:
  /// `foul`: intentional, so that the opponent with the ball cannot move for some cycles.
  BallRace(const WorldModel& world, bool foul) : world_(world) {
    const soccer::ServerParams& server = world.server();
    add(world.self_type(), {world.self.position, 0.0, foul ? 1 : server.tackle_cycles, true, 0});
    add_others(world.teammates, true, false);
    add_others(world.opponents, false, foul);
  }

  RaceResult run(Vec2 velocity) const {
    constexpr int kHorizon = 20;
    RaceResult result{kHorizon, kHorizon};
    Vec2 ball = world_.ball.position;

    for (int cycle = 1; cycle < kHorizon; ++cycle) {
      ball += velocity;
      velocity *= world_.server().ball_decay;
      if (outside_pitch(ball)) break;
      for (const Runner& runner : runners_) {
        int& first = runner.ours ? result.ours : result.theirs;
        if (first == kHorizon && gets_ball(runner, ball, cycle)) first = cycle;
      }
      if (result.ours < kHorizon && result.theirs < kHorizon) break;
    }

    return result;
  }

 private:
  struct Runner {
    Vec2 from;
    double control = 0.0;  ///< distance within which it kicks, meters
    int delay = 0;         ///< cycles until it can run
    bool ours = false;
    std::size_t type = 0;  ///< index into types_
  };

  void add(const soccer::PlayerType& type, Runner runner) {
    const auto known = std::ranges::find(types_, &type);
    runner.delay = std::max(0, runner.delay);
    runner.type = base::index(known - types_.begin());

    if (known == types_.end()) {
      types_.push_back(&type);
      reach_.push_back(ReachTable(world_.server(), type));
    }

    runner.control = type.kickable_area(world_.server().ball_size);
    runners_.push_back(runner);
  }

  void add_others(const PlayerList& players, bool ours, bool foul) {
    constexpr int kMaxAge = 15;
    const soccer::ServerParams& server = world_.server();
    for (const PlayerState& player : players) {
      if (player.ghost() || player.pos_count > kMaxAge || runners_.full()) continue;
      if (ours && player.goalie) continue;  // must not catch the ball

      const soccer::PlayerType& type = world_.type_of(player);
      const bool fouled = foul && player.dist_from_ball < type.kickable_area(server.ball_size);
      const int delay = player.tackling ? server.tackle_cycles / 2
                        : fouled        ? server.foul_cycles
                                        : 0;
      add(type, {player.position, 0.0, delay, ours, 0});
    }
  }

  bool gets_ball(const Runner& runner, Vec2 ball, int cycle) const {
    if (cycle < runner.delay) return false;
    const double far = runner.control + reach_[runner.type].run(cycle - runner.delay);
    return (ball - runner.from).squared_length() <= far * far;
  }

  const WorldModel& world_;
  base::FixedList<const soccer::PlayerType*, 22> types_;
  base::FixedList<ReachTable, 22> reach_;  ///< by index into types_
  base::FixedList<Runner, 22> runners_;
};

/// Ball velocity after a successful tackle in `direction`, degrees relative to the body.
Vec2 tackled_velocity(const WorldModel& world, double direction) {
  const auto& server = world.server();
  const double ball = (world.ball.angle_from_self - world.self.body).abs();
  const double share = 1.0 - std::fabs(math::normalize_degrees(direction)) / 180.0;
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
  constexpr TackleParameters kNumbers = kMovement.tackle;
  if (rolls_into_goal(world, velocity, soccer::kHalfLength)) return kNumbers.goal;
  if (rolls_into_goal(world, velocity, -soccer::kHalfLength)) return -kNumbers.goal;

  const Vec2 there = coast(world.ball.position, velocity, world.server().ball_decay, 5);
  const double from_goal = distance(there, kOwnGoal);
  const double outwards = std::fabs(there.y) - std::fabs(world.ball.position.y);

  const RaceResult result = race.run(velocity);
  const int lead = std::clamp(result.theirs - result.ours, -kNumbers.max_lead, kNumbers.max_lead);
  return kNumbers.own_goal * from_goal + outwards + kNumbers.possession * lead;
}

double best_direction(const WorldModel& world, bool foul) {
  constexpr int kDirections = 40;
  const BallRace race(world, foul);
  Highest<double> best{-1e9};

  for (int i = 0; i < kDirections; ++i) {
    const double direction = 360.0 * i / kDirections - 180.0;
    best.offer(outcome(world, race, tackled_velocity(world, direction)), direction);
  }

  return best.value;
}

bool is_tackle_needed(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  if (world.kickable_opponent()) return true;
  if (rolls_into_goal(world, world.ball.velocity, -soccer::kHalfLength)) return true;

  if (table.first_opponent_steps < table.our_steps() - 3) return true;
  const AngleDeg to_goal = AngleDeg::of(kOpponentGoal - world.self.position);
  const bool facing = (to_goal - world.self.body).abs() < 45.0;
  return table.best_self_steps() >= 5 && facing &&
         distance(world.ball.position, kOpponentGoal) < 10.0;
}

/// In our penalty area or at most half a meter beside it.
bool in_own_area(const WorldModel& world) { return in_own_box(world.ball.position, -0.5); }

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

    const AngleDeg to_goal = AngleDeg::of(kOwnGoal - opponent.position);
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
