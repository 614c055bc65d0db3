// Executes planned actions.
#include "player/planner/plan_execution.h"

#include <algorithm>
#include <cmath>

#include "player/ball_skills/ball_skills.h"
#include "player/movement/movement.h"
#include "player/perception/say_message.h"
#include "player/planner/field.h"
#include "player/planner/planner.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"

namespace cls::player {
namespace {

constexpr double kNearlyFull = 0.96;  ///< least share of the speed of a kick sequence

void say_pass(ActionContext& c, const PlanAction& action) {
  const Vec2 ball = c.world.ball.position;
  const Vec2 velocity = soccer::with_length(action.target_point - ball, action.first_speed);

  const SayPass pass{action.target,
                     action.target_point,
                     {ball + velocity, velocity * c.world.server().ball_decay}};
  std::string text;
  if (append_say_message(pass, c.world.server(), text)) c.slots.say(text);
}

void look_at(ActionContext& c, int unum) {
  const PlayerState* teammate = c.world.teammate(unum);
  if (teammate != nullptr && teammate->pos_count > 0) {
    c.neck = {NeckPlan::Kind::kPoint, teammate->position};
  } else {
    c.neck.kind = NeckPlan::Kind::kScan;
  }
}

bool pass(ActionContext& c, const PlanAction& action) {
  const WorldModel& world = c.world;
  look_at(c, action.target);

  const Vec2 target = action.target_point;
  const Vec2 way = target - world.ball.position;
  const Vec2 direction = way / std::max(1e-6, way.length());
  const double max = world.server().ball_speed_max;
  const bool at_once = world.game.mode != PlayMode::kPlayOn ||
                       max_speed_along(world.ball.velocity, direction, kick_limit(world), max) >=
                           action.first_speed - 1e-6;

  const bool kicked = at_once ? kick_one_step(world, c.slots, target, action.first_speed, false)
                              : smart_kick(world, c.slots, target, action.first_speed,
                                           kNearlyFull * action.first_speed, 3);
  if (!kicked) return c.slots.has_body();

  say_pass(c, action);
  return true;
}

bool dribble(ActionContext& c, const PlanAction& action) {
  const WorldModel& world = c.world;

  const bool open =
      world.game.mode == PlayMode::kPlayOn || soccer::is_penalty_mode(world.game.mode);
  if (!open || !kick_to_velocity(world, c.slots, action.first_velocity)) return false;

  c.memory.intention = {.kind = Intention::Kind::kDribble,
                        .target = action.target_point,
                        .heading = world.self.body + action.turn,
                        .turns = action.turns,
                        .dash_power = world.server().max_dash_power,
                        .dashes = action.dashes,
                        .last = world.game.time};

  constexpr double kNearGoal = 18.0;
  c.neck.kind = distance(action.target_point, kOpponentGoal) < kNearGoal
                    ? NeckPlan::Kind::kGoalieOrScan
                    : NeckPlan::Kind::kScan;

  return true;
}

bool shoot_hard(ActionContext& c) {
  const double max = c.world.server().ball_speed_max;
  c.neck = {NeckPlan::Kind::kPoint, kOpponentGoal};
  return (c.world.game.mode == PlayMode::kPlayOn &&
          smart_kick(c.world, c.slots, kOpponentGoal, max, kNearlyFull * max, 3)) ||
         kick_one_step(c.world, c.slots, kOpponentGoal, max, true);
}

bool opponent_is_at_ball(const WorldModel& world) {
  return world.intercept.first_opponent_steps <= 2;
}

/// Free space of a hard pass: lateral distance of the nearest opponent in meters, reduced with its
/// distance along the lane because it has time to approach.
double lane_room(const WorldModel& world, Vec2 target) {
  const Vec2 way = target - world.ball.position;
  const double length = way.length();
  double room = 10.0;

  for (const PlayerState& opponent : world.opponents) {
    if (opponent.pos_count > 10 || opponent.ghost()) continue;
    const Vec2 relative = opponent.position - world.ball.position;
    const double along = dot(relative, way) / length;
    if (along < 0.3 || along > length + 1.0) continue;

    const double beside = std::fabs(cross(way, relative)) / length;
    room = std::min(room, beside - 0.12 * along);
  }

  return room;
}

/// True if an opponent may tackle.
bool is_pressed(const WorldModel& world) {
  return std::ranges::any_of(world.opponents, [&](const PlayerState& opponent) {
    return opponent.dist_from_ball < world.planner->lay_off_pressure && opponent.pos_count <= 3 &&
           !opponent.ghost() && !opponent.tackling;
  });
}

/// Under pressure, or after holding for long.
bool wants_lay_off(const WorldModel& world, int ball_since) {
  const bool long_held =
      ball_since >= 0 && world.game.time.cycle - ball_since >= world.planner->lay_off_cycles;
  return long_held || is_pressed(world);
}

bool hold(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.game.mode != PlayMode::kPlayOn) return false;
  if (hold_kind(world, c.memory.ball_since) == HoldKind::kShoot && shoot_into_gap(c)) return true;
  if (wants_lay_off(world, c.memory.ball_since) && lay_off(c)) return true;
  return keep_ball(c);
}

}  // namespace

Gap widest_gap(const WorldModel& world) {
  constexpr int kTargets = 13;
  const double half = world.server().goal_width / 2.0 - 0.7;
  Highest<Vec2> best{0.0};

  for (int i = 0; i < kTargets; ++i) {
    const Vec2 target{soccer::kHalfLength, half * (2.0 * i / (kTargets - 1) - 1.0)};
    const Vec2 way = target - world.ball.position;
    const AngleDeg direction = AngleDeg::of(way);

    double gap = 90.0;
    for (const PlayerState& opponent : world.opponents) {
      if (opponent.pos_count > 10 || opponent.dist_from_ball > way.length()) continue;
      const double width = math::to_degrees(
          math::atan2(opponent.goalie ? 1.2 : 0.8, std::max(0.3, opponent.dist_from_ball)));
      gap = std::min(gap, (opponent.angle_from_ball - direction).abs() - width);
    }
    best.offer(gap, target);
  }
  return {best.score, best.value};
}

std::optional<Gap> gap_in_range(const WorldModel& world) {
  if (distance(world.ball.position, kOpponentGoal) > world.planner->late_shot_range) {
    return std::nullopt;
  }
  const Gap gap = widest_gap(world);
  return gap.degrees > 0.0 ? std::optional(gap) : std::nullopt;
}

bool shoot_into_gap(ActionContext& c) {
  const WorldModel& world = c.world;
  const std::optional<Gap> gap = gap_in_range(world);
  if (!gap) return false;

  const double max = world.server().ball_speed_max;
  c.neck = {NeckPlan::Kind::kPoint, gap->target};
  return (!opponent_is_at_ball(world) &&
          smart_kick(world, c.slots, gap->target, max, 0.9 * max, 2)) ||
         kick_one_step(world, c.slots, gap->target, max, true);
}

const PlayerState* lay_off_receiver(const WorldModel& world) {
  Highest<const PlayerState*> best{world.planner->lay_off_room};
  for (const PlayerState& teammate : world.teammates) {
    if (teammate.pos_count > 8 || teammate.ghost() || teammate.goalie ||
        teammate.position.x < -25.0 || teammate.position.x > world.lines.offside ||
        teammate.dist_from_ball < 4.0 || teammate.dist_from_ball > 30.0) {
      continue;
    }
    best.offer(lane_room(world, teammate.position), &teammate);
  }
  return best.value;
}

bool lay_off(ActionContext& c) {
  const WorldModel& world = c.world;
  const PlayerState* receiver = lay_off_receiver(world);
  if (receiver == nullptr) return false;
  constexpr double kArrival = 1.3;
  const double speed = kArrival + receiver->dist_from_ball * (1.0 - world.server().ball_decay);
  return pass(c, {.target = receiver->unum,
                  .target_point = receiver->position,
                  .first_speed = std::min(world.server().ball_speed_max, speed)});
}

bool keep_ball(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kScan;
  const Vec2 here = c.world.self.position;
  const bool in_own_goal_mouth = here.x < -44.5 && std::fabs(here.y) < 8.0;
  if (in_own_goal_mouth) return clear_ball(c.world, c.slots);
  return hold_ball(c.world, c.slots, false, {});
}

HoldKind hold_kind(const WorldModel& world, int ball_since) {
  const PlannerParameters& parameters = *world.planner;
  if (const std::optional<Gap> gap = gap_in_range(world)) {
    const bool pressed = opponent_is_at_ball(world);
    const double least = pressed ? parameters.late_shot_gap_pressed : parameters.late_shot_gap;
    if (gap->degrees >= least) return HoldKind::kShoot;
  }
  const bool lays_off = wants_lay_off(world, ball_since) && lay_off_receiver(world) != nullptr;
  return lays_off ? HoldKind::kLayOff : HoldKind::kKeep;
}

bool execute_action(ActionContext& c, const PlanAction& action) {
  switch (action.category) {
    case PlanCategory::kPass:
      return pass(c, action);
    case PlanCategory::kDribble:
      return dribble(c, action);
    case PlanCategory::kShoot:
      return shoot_hard(c);
    default:
      return hold(c);
  }
}

bool execute_plan(ActionContext& c, const Plan& plan, int node) {
  if (!c.world.self.kickable || plan.empty()) return false;
  return execute_action(c, plan.at(plan.first_of(node)).action);
}

bool execute_plan_or_hold(ActionContext& c, const Plan& plan, int node) {
  if (execute_plan(c, plan, node)) return true;
  c.neck.kind = NeckPlan::Kind::kScan;
  return hold_ball(c.world, c.slots, false, {});
}

const Plan& plan_of_decision(ActionContext& c, const PlannerOptions& options,
                             const NodeValue& value) {
  if (c.choice.plan.empty()) {
    const int held = c.memory.ball_since < 0 ? 0 : c.world.game.time.cycle - c.memory.ball_since;
    const PlannerField field(c.world, held);
    c.choice.plan = make_plan(field, options, value);
  }
  return c.choice.plan;
}

bool kick_outlet(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) return false;
  const PlannerField field(world);
  const std::optional<Outlet> outlet = best_outlet(field);
  if (!outlet) return clear_ball(world, c.slots);
  c.neck.kind = NeckPlan::Kind::kScan;
  return kick_one_step(world, c.slots, outlet->target, outlet->speed, true);
}

bool is_ball_in_danger(const WorldModel& world) {
  const PlannerParameters& parameters = *world.planner;
  if (world.game.mode != PlayMode::kPlayOn ||
      distance(world.ball.position, kOwnGoal) > parameters.outlet_range) {
    return false;
  }

  constexpr int kMaxAge = 10;
  return std::ranges::any_of(world.opponents, [&](const PlayerState& opponent) {
    return opponent.dist_from_ball < parameters.outlet_pressure && !opponent.ghost() &&
           opponent.pos_count <= kMaxAge;
  });
}

bool kick_out_of_danger(ActionContext& c) { return is_ball_in_danger(c.world) && kick_outlet(c); }

bool execute_default_plan(ActionContext& c) {
  if (!c.world.self.kickable) return false;
  if (kick_out_of_danger(c)) return true;
  const PlannerField field(c.world);
  const Plan plan = make_plan(field, PlannerOptions{});
  return execute_plan(c, plan, plan.best);
}

}  // namespace cls::player
