// Intercept prediction: every plan is executed by the rules of motion and must end at the ball.
#include "player/estimates/estimates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "player/perception/partial_update.h"
#include "player/world/motion.h"
#include "soccer/random.h"
#include "tests/player/estimates/known_world.h"

namespace cls::player {
namespace {

using tests::add;
using tests::known_world;

/// Executes a plan without noise (docs/spec/simulation-model.md 4.2, 4.3 and 3.1); returns the
/// final distance to the ball.
double distance_after(const WorldModel& world, const InterceptPlan& plan) {
  const soccer::ServerParams server;
  const soccer::PlayerType& type = world.self_type();
  Vec2 position = world.self.position;
  Vec2 velocity = world.self.velocity;
  double body = world.self.body.degrees();
  double missing = plan.turn_angle;

  for (int i = 0; i < plan.turns; ++i) {
    const double most = 180.0 / (1.0 + type.inertia_moment * velocity.length());
    const double turned = std::clamp(missing, -most, most);
    body += turned;
    missing -= turned;
    position += velocity;
    velocity *= type.player_decay;
  }

  const Vec2 ball =
      ball_after(world.ball.position, world.ball.velocity, plan.steps(), server.ball_decay);
  for (int i = 0; i < plan.dashes; ++i) {
    const Vec2 left = ball - position;
    const Vec2 heading = soccer::polar_degrees(1.0, body + plan.dash_direction);
    const double d = std::fabs(plan.dash_direction);
    const double rate =
        d > 90.0 ? 0.7 - 0.3 * (1.0 - (d - 90.0) / 90.0) : 0.4 + 0.6 * (1.0 - d / 90.0);
    if (soccer::dot(left, heading) > 0.0 || plan.kind == InterceptPlan::Kind::kOmniDash) {
      velocity += heading * (plan.dash_power * type.dash_power_rate * rate);
      velocity = velocity.length() > type.player_speed_max
                     ? soccer::with_length(velocity, type.player_speed_max)
                     : velocity;
    }
    position += velocity;
    velocity *= type.player_decay;
  }

  return soccer::distance(position, ball);
}

TEST(SelfIntercept, PlansEndAtBall) {
  soccer::RandomStream random(4, "plans");
  int plans = 0;
  int hopeless = 0;

  for (int i = 0; i < 200; ++i) {
    WorldModel world = known_world();
    world.self.position = {random.uniform(-30.0, 30.0), random.uniform(-20.0, 20.0)};
    world.self.body = AngleDeg(random.uniform(-180.0, 180.0));
    world.self.velocity = soccer::polar(random.uniform(0.0, 0.4), world.self.body);
    world.ball.position = world.self.position + soccer::polar_degrees(random.uniform(1.5, 20.0),
                                                                      random.uniform(-180, 180.0));
    world.ball.velocity =
        soccer::polar_degrees(random.uniform(0.0, 2.0), random.uniform(-180.0, 180.0));
    update_derived(world);

    const InterceptTable& table = world.intercept;
    if (table.plans.empty()) {  // the ball is too fast
      EXPECT_EQ(table.self_steps, kNever);
      ++hopeless;
      continue;
    }

    EXPECT_EQ(table.self_steps, table.plans[0].steps());
    const double area = world.self_type().kickable_area(0.085);
    for (const InterceptPlan& plan : table.plans) {
      EXPECT_LE(plan.ball_distance, area) << i;
      EXPECT_NEAR(distance_after(world, plan), plan.ball_distance, 1e-9) << i;
      ++plans;
    }
  }
  EXPECT_GT(plans, 1000);
  EXPECT_LT(hopeless, 10);
}

/// First cycle in which full dashes in a direction relative to the body end within `reach` of the
/// ball; 0: none up to `horizon`.
int first_reach(const WorldModel& world, double direction, double reach, int horizon) {
  const Vec2 push = dash_acceleration(world, world.server().max_dash_power, direction);
  Vec2 position = world.self.position;
  Vec2 velocity = world.self.velocity;
  for (int step = 1; step <= horizon; ++step) {
    velocity = speed_limited(velocity + push, world.self_type().player_speed_max);
    position += velocity;
    velocity *= world.self_type().player_decay;
    const Vec2 ball =
        ball_after(world.ball.position, world.ball.velocity, step, world.server().ball_decay);
    if (soccer::distance(position, ball) <= reach) return step;
  }
  return 0;
}

int first_plan(const InterceptTable& table, double direction) {
  const InterceptPlan* found = std::ranges::find_if(table.plans, [&](const InterceptPlan& plan) {
    return plan.kind == InterceptPlan::Kind::kOmniDash && plan.dash_direction == direction;
  });
  return found != table.plans.end() ? found->steps() : 0;
}

TEST(SelfIntercept, FindsFirstReachOfEveryDirection) {
  soccer::RandomStream random(5, "directions");
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    WorldModel world = known_world();
    world.self.body = AngleDeg(random.uniform(-180.0, 180.0));
    world.self.velocity =
        soccer::polar_degrees(random.uniform(0.0, 0.6), random.uniform(-180.0, 180.0));
    world.ball.position =
        soccer::polar_degrees(random.uniform(1.5, 12.0), random.uniform(-180.0, 180.0));
    world.ball.velocity =
        soccer::polar_degrees(random.uniform(0.0, 2.0), random.uniform(-180.0, 180.0));
    update_derived(world);

    const double reach = world.self_type().kickable_area(world.server().ball_size) - 0.1;
    for (const double direction : {0.0, 45.0, -45.0, 90.0, -90.0, 135.0, -135.0, 180.0}) {
      const int first = first_reach(world, direction, reach, direction == 0.0 ? 50 : 12);
      EXPECT_EQ(first_plan(world.intercept, direction), first) << i << ' ' << direction;
      if (first != 0) ++found;
    }
  }

  EXPECT_GT(found, 50);
}

TEST(SelfIntercept, IsZeroStepsWhenKickable) {
  WorldModel world = known_world();
  world.ball.position = {0.5, 0.0};
  update_derived(world);
  EXPECT_TRUE(world.self.kickable);
  EXPECT_EQ(world.intercept.self_steps, 0);
  EXPECT_TRUE(world.intercept.plans.empty());
}

TEST(SelfIntercept, CountsTurnAsCycle) {
  WorldModel ahead = known_world();
  ahead.ball.position = {8.0, 0.0};
  update_derived(ahead);
  WorldModel aside = ahead;
  aside.ball.position = {0.0, 8.0};
  update_derived(aside);
  EXPECT_EQ(aside.intercept.self_steps, ahead.intercept.self_steps + 1);
  EXPECT_EQ(ahead.intercept.plans[0].kind, InterceptPlan::Kind::kOmniDash);
  EXPECT_EQ(aside.intercept.plans[0].kind, InterceptPlan::Kind::kTurnForwardDash);
  EXPECT_NEAR(aside.intercept.plans[0].turn_angle, 90.0, 1e-9);
}

TEST(SelfIntercept, DistinguishesExhaustingPlans) {
  WorldModel world = known_world();
  world.ball.position = {15.0, 0.0};
  world.self.stamina = 2500.0;  // the threshold is 2400
  update_derived(world);
  EXPECT_EQ(world.intercept.self_steps, kNever);
  EXPECT_LT(world.intercept.self_exhausting_steps, 30);
  EXPECT_EQ(world.intercept.best_self_steps(), world.intercept.self_exhausting_steps);
}

TEST(InterceptTable, RanksTeammatesAndOpponents) {
  WorldModel world = known_world();
  world.self.position = {-30.0, 0.0};
  world.ball.position = {0.0, 0.0};
  add(world, Side::kLeft, 2, {-10.0, 0.0});
  add(world, Side::kLeft, 3, {5.0, 0.0});
  add(world, Side::kLeft, 4, {20.0, 0.0});
  add(world, Side::kRight, 5, {0.0, 0.5});
  add(world, Side::kRight, 6, {0.0, 25.0});
  update_derived(world);

  const InterceptTable& table = world.intercept;
  EXPECT_EQ(table.first_teammate_id, world.teammates[1].id);
  EXPECT_EQ(table.second_teammate_id, world.teammates[0].id);
  EXPECT_LT(table.first_teammate_steps, table.second_teammate_steps);
  // 5 m to run less the kickable area 1.085: four full dashes from rest carry 3.12 m, five 4.09 m.
  EXPECT_EQ(table.first_teammate_steps, 5);
  EXPECT_EQ(table.first_opponent_steps, 0);
  EXPECT_EQ(table.first_opponent_id, world.opponents[0].id);
  EXPECT_TRUE(world.kickable_opponent());
  EXPECT_FALSE(world.kickable_teammate());
  EXPECT_EQ(world.teammates[1].ball_reach_steps, 5);
}

TEST(InterceptTable, IgnoresOldPositionsAndIsEmptyBeforeKickOff) {
  WorldModel world = known_world();
  world.ball.position = {0.0, 0.0};
  world.self.position = {-30.0, 0.0};
  add(world, Side::kLeft, 2, {-10.0, 0.0}, 10);
  add(world, Side::kRight, 5, {4.0, 0.0}, 14);
  update_derived(world);
  EXPECT_EQ(world.intercept.first_teammate_steps, kNever);
  EXPECT_EQ(world.teammates[0].ball_reach_steps, kNever);
  EXPECT_LT(world.intercept.first_opponent_steps, kNever);

  world.game.mode = PlayMode::kBeforeKickOff;
  update_derived(world);
  EXPECT_EQ(world.intercept.self_steps, kNever);
  EXPECT_EQ(world.intercept.first_opponent_steps, kNever);
  EXPECT_EQ(world.intercept.first_opponent_id, 0);
}

TEST(InterceptTable, ChasingTakesLongerThanMeetingBall) {
  WorldModel world = known_world();
  world.self.position = {-40.0, 0.0};
  world.ball.position = {0.0, 0.0};
  world.ball.velocity = {1.5, 0.0};
  add(world, Side::kRight, 5, {-5.0, 0.0});
  add(world, Side::kRight, 6, {10.0, 1.0});
  update_derived(world);
  EXPECT_LT(world.opponents[1].ball_reach_steps, 8);
  EXPECT_GT(world.opponents[0].ball_reach_steps, 15);
}

/// The agent, the ball and players around it at random, some not seen for a while.
WorldModel random_world(soccer::RandomStream& random) {
  WorldModel world = known_world();
  world.leg_dashes = true;
  const auto near = [&](double most) {
    return soccer::polar_degrees(random.uniform(0.0, most), random.uniform(-180.0, 180.0));
  };
  world.self.position = near(25.0);
  world.self.body = AngleDeg(random.uniform(-180.0, 180.0));
  world.self.velocity = near(0.5);
  world.ball.position = world.self.position + near(random.unit() < 0.3 ? 1.2 : 15.0);
  world.ball.velocity = near(2.0);
  const int players = random.integer(8);
  for (int unum = 1; unum <= players; ++unum) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      add(world, side, unum, world.ball.position + near(30.0), random.integer(12)).body =
          AngleDeg(random.uniform(-180.0, 180.0));
    }
  }
  return world;
}

/// What looking and the team lines read.
void expect_same_besides_own_plans(const WorldModel& all, const WorldModel& first) {
  const auto reached = [](const WorldModel& world) {
    return std::min(world.intercept.our_steps(), world.intercept.first_opponent_steps);
  };
  EXPECT_EQ(reached(first), reached(all));
  EXPECT_EQ(first.intercept.first_teammate_steps, all.intercept.first_teammate_steps);
  EXPECT_EQ(first.intercept.first_opponent_steps, all.intercept.first_opponent_steps);
  EXPECT_EQ(first.intercept.second_opponent_id, all.intercept.second_opponent_id);
  EXPECT_EQ(first.self.kickable, all.self.kickable);
  EXPECT_EQ(first.self.foul_probability, all.self.foul_probability);
  EXPECT_EQ(first.lines.offside, all.lines.offside);
  EXPECT_EQ(first.lines.offside_count, all.lines.offside_count);
}

TEST(InterceptTable, HasFirstOwnPlansOnlyForLooking) {
  soccer::RandomStream random(6, "first plans");
  int fewer = 0;
  int reaching = 0;

  for (int i = 0; i < 1000; ++i) {
    WorldModel all = random_world(random);
    WorldModel first = all;
    update_derived(all);
    update_derived_for_looking(first);
    SCOPED_TRACE(i);
    expect_same_besides_own_plans(all, first);

    const InterceptTable& table = all.intercept;
    const int others = std::min(table.first_teammate_steps, table.first_opponent_steps);
    const auto within = std::ranges::count_if(
        table.plans, [&](const InterceptPlan& plan) { return plan.steps() <= others; });
    if (first.intercept.plans.size() < table.plans.size()) {
      EXPECT_EQ(first.intercept.plans.size(), static_cast<std::size_t>(within));
      ++fewer;
    }
    const int own = first.intercept.best_self_steps();
    EXPECT_EQ(own,
              own == kNever && table.best_self_steps() > others ? kNever : table.best_self_steps());
    if (own > 0 && own < kNever) ++reaching;
  }
  EXPECT_GT(fewer, 300);
  EXPECT_GT(reaching, 100);
}

}  // namespace
}  // namespace cls::player
