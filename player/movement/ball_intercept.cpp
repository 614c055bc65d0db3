// Selects an intercept plan and executes its first command.
#include "player/movement/movement.h"

#include <algorithm>
#include <cmath>

#include "player/movement/movement_parameters.h"
#include "player/world/candidates.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

using Kind = InterceptPlan::Kind;

constexpr InterceptParameters kNumbers = kMovement.intercept;
constexpr double kPitchInset = 1.0;  ///< balls nearer to the lines may leave the pitch, meters

/// Penalty for players who reach the ball before this plan; zero or negative.
double race_score(const WorldModel& world, int steps) {
  const InterceptTable& table = world.intercept;
  const PlayerState* opponent = world.player_by_id(table.first_opponent_id);
  const int age =
      opponent != nullptr ? std::min(kNumbers.max_opponent_age, opponent->pos_count) : 0;
  const int late = steps + kNumbers.others_delay;
  const double ahead_of_opponent = table.first_opponent_steps - age - late;
  const double ahead_of_teammate = table.first_teammate_steps - late;
  return kNumbers.opponent_lead * std::min(0.0, ahead_of_opponent) +
         kNumbers.teammate_lead * std::min(0.0, ahead_of_teammate);
}

double turn_score(const WorldModel& world, const InterceptPlan& plan) {
  if (plan.turns == 0) return 0.0;
  const double turn = std::fabs(plan.turn_angle);

  // Prefer continuing without a turn unless the turn is clearly better.
  double score = -kNumbers.turn;
  if (plan.ball_distance > kickable_area(world) - kNumbers.edge) {
    score -= kNumbers.turn_degree * turn;
  }
  if (plan.kind == Kind::kTurnBackwardDash && turn > 90.0) {
    score -= kNumbers.back_degree * (turn - 90.0);
  }
  return score;
}

/// Penalty for a ball that will be slow: another player may intercept it earlier.
double slow_ball_score(const WorldModel& world, const InterceptPlan& plan, Vec2 velocity) {
  const AngleDeg run = AngleDeg::of(plan.self_position - world.self.position);
  const double speed = velocity.length();
  if (plan.dashes > 0 && speed > 1e-3 && (AngleDeg::of(velocity) - run).abs() < 15.0) {
    const double fast =
        kNumbers.outrun_share * world.self_type().real_speed_max(world.server().max_dash_power);
    return -kNumbers.outrun * std::max(0.0, fast - speed);
  }

  const double missing = std::max(0.0, kNumbers.min_ball_speed - speed);
  return -kNumbers.slow_ball * missing * missing;
}

double plan_score(const WorldModel& world, const InterceptPlan& plan) {
  const int steps = plan.steps();
  const Vec2 ball = ball_after(world, steps);
  if (outside_pitch(ball, kPitchInset)) return -kNumbers.impossible - steps;

  const double area = kickable_area(world);
  const Vec2 velocity = world.ball.velocity * power_of(world.server().ball_decay, steps);
  const double dx = ball.x - kNumbers.goal_x;
  const double dy = ball.y / 2.0;

  double score = -kNumbers.goal_meter * std::sqrt(dx * dx + dy * dy) - kNumbers.cycle * steps +
                 race_score(world, steps) + turn_score(world, plan) +
                 slow_ball_score(world, plan, velocity);

  const double moved = distance(plan.self_position, world.self.position);
  const double wide_edge = area - kNumbers.wide_edge;
  score -= kNumbers.run * moved;
  if (plan.ball_distance > area - kNumbers.edge) score -= kNumbers.edge_run * moved;
  if (plan.ball_distance > wide_edge) {
    score -= kNumbers.wide_edge_meter * (plan.ball_distance - wide_edge) + kNumbers.wide_edge_cost;
  }
  score += kNumbers.stamina * (plan.stamina - world.self.stamina);

  const double off_body = (world.ball.angle_from_self - world.self.body).abs();
  const bool duel = world.kickable_opponent() && plan.kind != Kind::kTurnForwardDash;
  return duel && off_body > 40.0 ? score - kNumbers.duel : score;
}

/// The goalie prefers an early and close intercept.
double goalie_score(const WorldModel& world, const InterceptPlan& plan) {
  const Vec2 ball = ball_after(world, plan.steps());
  if (outside_pitch(ball, kPitchInset)) return -kNumbers.impossible - plan.steps();
  return race_score(world, plan.steps()) - plan.steps() - plan.ball_distance +
         turn_score(world, plan);
}

const InterceptPlan* best_plan(const WorldModel& world, bool save_recovery) {
  const bool own_area =
      world.goalie && world.ball.position.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength;

  Highest<const InterceptPlan*> best{0.0};
  for (const InterceptPlan& plan : world.intercept.plans) {
    if (save_recovery && plan.exhausting) continue;
    const double score = own_area ? goalie_score(world, plan) : plan_score(world, plan);
    if (best.value == nullptr) best = {score, &plan};
    best.offer(score, &plan);
  }

  return best.value;
}

/// Waits for the ball facing `face_point`, or the ball if the neck could not follow it.
bool wait_for_ball(const WorldModel& world, CommandSlots& slots, Vec2 face_point, int steps) {
  const Vec2 here = self_after(world, steps);
  const AngleDeg desired = AngleDeg::of(face_point - here);
  const AngleDeg ball = AngleDeg::of(ball_after(world, 1) - self_after(world, 1));
  const double in_sight = world.server().maxneckang + 25.0;
  const AngleDeg body = (ball - desired).abs() < in_sight ? desired : ball;
  return slots.turn((body - world.self.body).degrees());
}

}  // namespace

bool intercept(const WorldModel& world, CommandSlots& slots, bool save_recovery, Vec2 face_point) {
  const double area = kickable_area(world);
  const InterceptPlan* plan = best_plan(world, save_recovery);
  if (plan == nullptr || plan->steps() > 100) {
    const Vec2 rest =
        rest_point(world.ball.position, world.ball.velocity, world.server().ball_decay);
    go_to_point(world, slots, rest, area - 0.2, world.server().max_dash_power);
    return slots.has_body();
  }

  if (plan->dashes == 0 && plan->steps() <= 1) return wait_for_ball(world, slots, face_point, 1);
  if (plan->turns > 0) return slots.turn(plan->turn_angle);

  const double threshold = world.server().recover_dec_thr * world.server().stamina_max;
  const bool tired = save_recovery && world.self.stamina - plan->dash_power < threshold;
  const bool comes_by_itself =
      distance(ball_after(world, plan->steps()), self_after(world, plan->steps())) < area - 0.3;
  if (tired || comes_by_itself || plan->dashes == 0) {
    return wait_for_ball(world, slots, face_point, plan->steps());
  }

  if (plan->leg_turn) {
    const std::optional<LegTurn> turn = leg_turn(world, plan->turn_angle, plan->dash_power);
    if (turn) return slots.dash(turn->legs);
  }
  return slots.dash(plan->dash_power, plan->dash_direction);
}

}  // namespace cls::player
