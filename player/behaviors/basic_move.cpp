// Decides the move of a player without the ball.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <optional>

#include "base/index.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/movement/home_positions.h"
#include "player/movement/movement.h"
#include "player/movement/off_ball.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"
#include "soccer/interval.h"

namespace cls::player {

namespace {

constexpr PaceParameters kNumbers = kBehaviors.pace;

}  // namespace

double running_pace(const WorldModel& world) {
  const soccer::ServerParams& server = world.server();
  const int half = server.half_time_cycles();
  const int cycle = world.game.time.cycle;
  const bool is_limited = server.stamina_capacity > 0.0 && world.self.capacity >= 0.0;
  if (!is_limited || half <= 0 || cycle >= server.normal_time_cycles()) return 1.0;

  const double remaining_time = static_cast<double>(half - cycle % half) / half;
  const double even = (server.stamina_max + server.stamina_capacity) * remaining_time;
  const double ahead = (world.self.stamina + world.self.capacity) / even - 1.0;

  return std::clamp(1.0 + world.planner->pace * ahead, kNumbers.slowest, kNumbers.fastest);
}

double normal_dash_power(const WorldModel& world, bool& recovering) {
  const SelfState& self = world.self;
  const double max = world.server().max_dash_power;
  const double stamina_max = world.server().stamina_max;
  const PlannerParameters& parameters = *world.planner;
  if (self.stamina < parameters.tired_below * stamina_max) recovering = true;
  if (self.stamina > parameters.rested_above * stamina_max) recovering = false;

  const double income = world.self_type().stamina_inc_max * self.recovery;
  const InterceptTable& table = world.intercept;
  const Vec2 ball = first_reach_point(world);

  if (self.capacity == 0.0) return std::min(max, self.stamina + world.self_type().extra_stamina);
  if (self.position.x < world.lines.our_defense &&
      ball.x < world.lines.our_defense + kNumbers.behind_line) {
    return max;
  }
  if (recovering) return std::max(0.0, income - kNumbers.rest);
  if (world.kickable_teammate() && world.ball.dist_from_self < kNumbers.close_ball) {
    return std::min(max, parameters.run_power_near * income);
  }

  if (self.position.x > world.lines.offside) return max;
  if (ball.x > kNumbers.attack_x && ball.x > self.position.x + kNumbers.attack_ahead &&
      table.our_steps() < table.first_opponent_steps - kNumbers.safe_lead) {
    return soccer::between(kNumbers.attack_share * income, kNumbers.attack_power, max);
  }

  return std::min(max, running_pace(world) * parameters.run_power * income);
}

bool basic_move(ActionContext& c) {
  const WorldModel& world = c.world;
  CommandSlots& slots = c.slots;
  NeckPlan& neck = c.neck;
  if (basic_tackle(world, slots, world.planner->tackle_chance)) {
    neck.kind = NeckPlan::Kind::kBall;
    return true;
  }

  const InterceptTable& table = world.intercept;
  const int self = table.best_self_steps();
  const bool ours_to_get =
      self <= 3 || (self <= table.first_teammate_steps && self < table.first_opponent_steps + 3);
  if (!world.kickable_teammate() && ours_to_get && self < kNever &&
      !must_leave_ball(world, c.memory)) {
    neck.kind = NeckPlan::Kind::kOffensiveIntercept;
    return intercept(world, slots, true, kOpponentGoal);
  }

  if (const std::optional<Vec2> block = block_point(world)) {
    neck.kind = NeckPlan::Kind::kBall;
    const double max = world.server().max_dash_power;
    if (go_to_point(world, slots, *block, 0.4, max, {3, 20.0, true})) return true;
    return turn_to_ball(world, slots) || slots.has_body();
  }

  const TeamPoints homes = home_positions(world);
  if (const std::optional<Vec2> support = support_point(world, homes)) {
    neck.kind = NeckPlan::Kind::kBallOrScan;
    const double power = safe_dash_power(world, world.server().max_dash_power);
    if (!go_to_point(world, slots, *support, 1.0, power)) turn_to_ball(world, slots);
    return slots.has_body();
  }

  const std::optional<Mark> mark = find_mark(world, homes, marking_in_open_play(world));
  const Vec2 home = mark ? mark->point : homes[base::index(world.unum - 1)];
  const double usual_threshold = std::max(1.0, 0.1 * world.ball.dist_from_self);
  const double threshold = mark ? 0.5 : usual_threshold / std::min(1.0, running_pace(world));
  const double usual = normal_dash_power(world, c.memory.recovering);
  const double power = mark ? world.server().max_dash_power : usual;

  if (!go_to_point(world, slots, home, threshold, power)) turn_to_ball(world, slots);
  const bool duel = world.kickable_opponent() && world.ball.dist_from_self < 18.0;
  neck.kind = duel ? NeckPlan::Kind::kBall : NeckPlan::Kind::kBallOrScan;
  return slots.has_body();
}

}  // namespace cls::player
