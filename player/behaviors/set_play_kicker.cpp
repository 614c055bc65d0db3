// The kicker of a set play: goes behind the ball, scans, passes.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <limits>

#include "base/index.h"
#include "player/ball_skills/ball_skills.h"
#include "player/movement/home_positions.h"
#include "player/movement/movement.h"
#include "player/planner/field.h"
#include "player/planner/plan_execution.h"
#include "player/planner/planner.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"

namespace cls::player {
namespace {

/// Direction in which the kicker approaches the ball.
AngleDeg kick_direction(const WorldModel& world) {
  const PlayMode kind = without_side(world.game.mode);
  const Vec2 ball = world.ball.position;
  if (kind == PlayMode::kKickInLeft) return AngleDeg(ball.y > 0.0 ? -90.0 : 90.0);
  if (kind == PlayMode::kCornerKickLeft) return AngleDeg::of(Vec2{44.0, 0.0} - ball);
  return AngleDeg(0.0);
}

/// View direction while waiting: sweeps over the teammates.
AngleDeg waiting_direction(const WorldModel& world, AngleDeg direction) {
  if (without_side(world.game.mode) == PlayMode::kKickOffLeft) direction = AngleDeg(180.0);
  constexpr double kSweep = 40.0;
  return direction + (world.game.time.cycle % 8 < 4 ? kSweep : -kSweep);
}

/// True while teammates need time to take positions.
bool teammates_need_time(const WorldModel& world) {
  const GameState& game = world.game;
  const int since = game.time.cycle - game.last_set_play_start;
  const PlayMode kind = without_side(game.mode);

  constexpr int kDropMargin = 5;
  if (since >= world.server().drop_ball_time - kDropMargin) return false;
  if (game.set_play_count < 3) return true;
  const bool seen = game.see_time == game.time.cycle;
  const int patience = kind == PlayMode::kKickOffLeft    ? 20
                       : kind == PlayMode::kGoalKickLeft ? 30
                                                         : 12;

  return since < patience || !seen;
}

bool teammate_asked_to_wait(const WorldModel& world) {
  for (const HeardMessage& heard : world.heard) {
    const bool teammate = !heard.coach && heard.side == world.our_side && heard.unum != world.unum;
    if (teammate && heard.text.starts_with('w')) return true;
  }
  return false;
}

/// Runs to the position behind the ball, around it.
bool go_behind_ball(ActionContext& c, AngleDeg direction) {
  const WorldModel& world = c.world;
  const Vec2 ball = world.ball.position;
  const double gap = collide_distance(world) + 0.25;
  const Vec2 position = ball - soccer::polar(gap, direction);
  const double away = distance(world.self.position, position);

  c.neck.kind = world.ball.pos_count > 2 ? NeckPlan::Kind::kBall : NeckPlan::Kind::kBallOrScan;
  constexpr double kClose = 0.25;
  if (away < kClose || (world.self.kickable && away < 0.6)) return false;

  // Slow down: running into the ball would move it.
  const double power = away < 2.0 ? 40.0 : away < 5.0 ? 70.0 : world.server().max_dash_power;
  const AngleDeg way = AngleDeg::of(position - world.self.position);
  const AngleDeg to_ball = AngleDeg::of(ball - world.self.position);
  const bool in_the_way = distance(ball, world.self.position) < away + 0.3 &&
                          (way - to_ball).abs() < 45.0 && away > 0.6;
  if (in_the_way) return go_to_point_dodge(world, c.slots, position, safe_dash_power(world, power));

  return go_to_point(world, c.slots, position, kClose, safe_dash_power(world, power), {10});
}

/// Nearest unmarked teammate between 8 and 25 m.
const PlayerState* unmarked_teammate(const WorldModel& world) {
  constexpr double kRoom = 3.0;
  Lowest<const PlayerState*> best{std::numeric_limits<double>::infinity()};

  for (const PlayerState& teammate : world.teammates) {
    if (teammate.pos_count > 10 || teammate.ghost() || teammate.goalie ||
        teammate.position.x < -40.0 || teammate.dist_from_ball < 8.0 ||
        teammate.dist_from_ball > 25.0) {
      continue;
    }
    const bool covered = std::ranges::any_of(world.opponents, [&](const PlayerState& opponent) {
      return opponent.position_valid() && distance(opponent.position, teammate.position) < kRoom;
    });
    if (!covered) best.offer(teammate.dist_from_ball, &teammate);
  }

  return best.value;
}

}  // namespace

bool play_planned_pass(ActionContext& c) {
  if (!c.world.self.kickable) return false;

  const PlannerField field(c.world);
  PlannerOptions options;
  options.short_dribble = options.long_dribble = false;
  const Plan plan = make_plan(field, options);

  const int first = plan.first_of(plan.best);
  if (plan.at(first).action.category == PlanCategory::kPass)
    return execute_plan(c, plan, plan.best);

  // Holding is impossible in a set play: take the best pass.
  int best = 0;
  for (int i = 1; i < std::ssize(plan.nodes); ++i) {
    if (plan.at(i).depth == 1 && (best == 0 || plan.at(i).value > plan.at(best).value)) best = i;
  }
  return best != 0 && execute_plan(c, plan, best);
}

bool kick_into_play(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) return false;
  if (play_planned_pass(c)) return true;

  c.neck.kind = NeckPlan::Kind::kScan;
  if (const PlayerState* teammate = unmarked_teammate(world)) {
    constexpr double kArrival = 1.2;
    const double decay = world.server().ball_decay;
    const double speed = kArrival + teammate->dist_from_ball * (1.0 - decay);
    return kick_one_step(world, c.slots, teammate->position, speed, true);
  }

  return advance_ball(world, c.slots);
}

int set_play_kicker(const WorldModel& world) {
  const TeamPoints homes = home_positions(world);
  const Vec2 ball = world.ball.position;
  int first = 0;
  int second = 0;
  const auto home_distance = [&](int unum) { return distance(homes[base::index(unum - 1)], ball); };

  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const PlayerState* teammate = world.teammate(unum);
    const bool self = unum == world.unum;
    const bool goalie = self ? world.goalie : teammate != nullptr && teammate->goalie;
    if (goalie || unum == world.our_goalie_unum) continue;
    if (first == 0 || home_distance(unum) < home_distance(first)) {
      second = first;
      first = unum;
    } else if (second == 0 || home_distance(unum) < home_distance(second)) {
      second = unum;
    }
  }

  if (second == 0 || home_distance(first) < 0.95 * home_distance(second)) return first;
  const auto real_distance = [&](int unum) {
    if (unum == world.unum) return distance(world.self.position, ball);
    const PlayerState* teammate = world.teammate(unum);
    return teammate != nullptr ? distance(teammate->position, ball) : 1000.0;
  };
  return real_distance(second) < real_distance(first) ? second : first;
}

bool kick_set_play(ActionContext& c) {
  const WorldModel& world = c.world;
  const AngleDeg direction = kick_direction(world);

  if (go_behind_ball(c, direction)) return true;
  if (!world.self.kickable) {
    // Arrived, but not kickable: the ball estimate was wrong.
    const Vec2 ball = world.ball.position;
    c.neck.kind = NeckPlan::Kind::kBall;
    if (go_to_point(world, c.slots, ball, 0.5, 30.0, {10})) return true;
    return turn_to_ball(world, c.slots) || c.slots.turn(0.0);
  }

  const bool wait = teammates_need_time(world) || teammate_asked_to_wait(world);
  const int since = world.game.time.cycle - world.game.last_set_play_start;
  const bool due = since >= world.server().drop_ball_time - 5;
  c.neck.kind = NeckPlan::Kind::kScan;
  if (wait && !due) return turn_to_angle(world, c.slots, waiting_direction(world, direction));
  if (without_side(world.game.mode) == PlayMode::kGoalKickLeft) return kick_outlet(c);

  constexpr int kPassPatience = 45;
  if (play_planned_pass(c)) return true;
  if (!due && since < kPassPatience) {
    return turn_to_angle(world, c.slots, waiting_direction(world, direction));
  }

  return kick_into_play(c);
}

}  // namespace cls::player
