// Parameters of the planner: their table, and what they change.
#include "player/world/planner_parameters.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "player/behaviors/behaviors.h"
#include "player/movement/home_positions.h"
#include "player/movement/off_ball.h"
#include "player/planner/generators.h"
#include "player/planner/plan_execution.h"
#include "player/planner/planner.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;
using tests::KnownPitch;

TEST(PlannerParameters, HaveDistinctNamesAndDefaultsWithinTheirRange) {
  const player::PlannerParameters defaults;
  std::set<std::string_view> names;
  for (const player::PlannerParameter& row : player::planner_parameter_table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_GE(value_of(defaults, row), row.low) << row.name;
    EXPECT_LE(value_of(defaults, row), row.high) << row.name;
    EXPECT_LT(row.low, row.high) << row.name;
  }
}

TEST(PlannerParameters, SetsOnlyTheNamedOne) {
  for (const player::PlannerParameter& row : player::planner_parameter_table()) {
    player::PlannerParameters parameters;
    ASSERT_TRUE(set_planner_parameter(parameters, row.name, row.high)) << row.name;
    for (const player::PlannerParameter& other : player::planner_parameter_table()) {
      const double expected =
          other.name == row.name ? row.high : value_of(player::PlannerParameters(), other);
      EXPECT_EQ(value_of(parameters, other), expected) << row.name << " and " << other.name;
    }
  }
}

TEST(PlannerParameters, RefusesWrongNamesAndValues) {
  player::PlannerParameters parameters;
  const auto error = [&](std::string_view name, double value) {
    const auto set = set_planner_parameter(parameters, name, value);
    return set ? "accepted" : set.error().message;
  };

  EXPECT_EQ(error("x_wieght", 1.0), "unknown parameter 'x_wieght'; did you mean 'x_weight'?");
  EXPECT_EQ(error("x_weight", 10.1), "x_weight: must be a number from 0 to 10 (points/m)");
  EXPECT_EQ(error("x_weight", std::numeric_limits<double>::quiet_NaN()),
            "x_weight: must be a number from 0 to 10 (points/m)");
  EXPECT_EQ(error("self_pass_dashes", 4.5),
            "self_pass_dashes: must be a whole number from 1 to 20 (cycles)");
  EXPECT_EQ(error("x_weight", 10.0), "accepted") << "bounds are allowed";
}

TEST(PlannerParameters, ChangeTheValueOfStates) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_opponent(4, {11.0, 0.0});
  player::Plan plan;
  player::PlanNode node;
  node.holder = 7;
  node.depth = 3;
  node.ball = {10.0, 0.0};
  node.time = 12;
  plan.nodes.push_back(node);
  const auto value = [&] { return default_value(player::PlannerField(pitch.world), plan, 0); };
  const double usual = value();

  const auto change = [&](std::string_view name, double to) {
    const auto before = pitch.world.planner;
    pitch.set_parameter(name, to);
    const double changed = value() - usual;
    pitch.world.planner = before;
    return changed;
  };

  EXPECT_NEAR(change("cycle_cost", 1.25), -12.0, 1e-9);
  EXPECT_NEAR(change("action_cost", 3.0), -4.0, 1e-9);
  EXPECT_NEAR(change("x_weight", 2.0), 62.5, 1e-9);
  EXPECT_NEAR(change("goal_radius", 50.0), 7.5, 1e-9);
  EXPECT_NEAR(change("pressure_cost", 2.5), -2.0, 1e-9);
  EXPECT_NEAR(change("pressure_distance", 1.0), 3.0, 1e-9);
  EXPECT_DOUBLE_EQ(change("hold_pressure_cost", 5.0), 0.0) << "a pass";

  plan.nodes[0].depth = 0;
  const double held = value();
  pitch.set_parameter("hold_pressure_cost", 5.0);

  EXPECT_NEAR(value() - held, -10.0, 1e-9);
}

TEST(PlannerParameters, ChangeWhichPassesAreGenerated) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {46.0, -30.0});
  pitch.add_opponent(4, {10.0, 4.0});
  pitch.add_teammate(9, {16.0, 9.0});

  const auto passes = [&] {
    std::vector<player::PlanAction> actions;
    add_passes(player::PlannerField(pitch.world), actions);
    return actions.size();
  };
  const std::size_t usual = passes();
  pitch.set_parameter("pass_margin", 3.0);

  EXPECT_LT(passes(), usual);

  pitch.set_parameter("pass_margin", 0.0);
  EXPECT_GT(passes(), usual);
  pitch.set_parameter("pass_distance", 10.0);
  EXPECT_EQ(passes(), 0U);
}

TEST(PlannerParameters, ChangeWhenTheBallIsLaidOff) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_teammate(5, {-8.0, 14.0});
  pitch.add_opponent(4, {2.1, 0.0});
  pitch.add_opponent(6, {-1.2, 10.6});  // four meters next to the lane
  player::Plan hold;
  hold.nodes.emplace_back();

  const auto lays_off = [&] {
    player::NeckPlan neck;
    player::PlanChoice choice;
    player::CommandSlots slots(pitch.world);
    player::ActionContext context{pitch.world, pitch.memory, slots, neck, pitch.report, choice};
    EXPECT_TRUE(execute_plan(context, hold, 0));
    return slots.say_text().starts_with('p');  // a pass is announced
  };

  EXPECT_FALSE(lays_off());

  pitch.set_parameter("lay_off_pressure", 2.0);
  EXPECT_TRUE(lays_off());
  pitch.set_parameter("lay_off_room", 5.0);
  EXPECT_FALSE(lays_off());
}

TEST(PlannerParameters, ChangeOutlets) {
  KnownPitch pitch;
  pitch.place_self({-45.0, 0.0});
  pitch.place_ball({-44.5, 0.0});
  pitch.add_teammate(6, {-30.0, 20.0}, 180.0);
  EXPECT_TRUE(best_outlet(player::PlannerField(pitch.world))->teammate_first);
  pitch.set_parameter("outlet_gain", 0.0);
  pitch.set_parameter("outlet_kick_in", 100.0);
  EXPECT_FALSE(best_outlet(player::PlannerField(pitch.world))->teammate_first);
}

TEST(PlannerParameters, ShiftHomePositionsOfFieldPlayers) {
  KnownPitch pitch;
  pitch.place_ball({0.0, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {48.0, 0.0});

  ASSERT_EQ(formation_kind(pitch.world), player::FormationKind::kOffense);
  const player::TeamPoints usual = home_positions(pitch.world);
  pitch.set_parameter("shift_offense", 4.0);
  pitch.set_parameter("shift_defense", -20.0);
  const player::TeamPoints shifted = home_positions(pitch.world);

  EXPECT_EQ(shifted[0].x, usual[0].x) << "the goalie stays";
  for (std::size_t i = 1; i < usual.size(); ++i) {
    EXPECT_NEAR(shifted[i].x, usual[i].x + 4.0, 1e-9) << i + 1;
    EXPECT_EQ(shifted[i].y, usual[i].y);
  }
}

TEST(PlannerParameters, ChangeWhereDribblersAreBlocked) {
  KnownPitch pitch;
  pitch.world.unum = 3;
  pitch.place_self({-35.0, 5.0}, 90.0);
  pitch.place_ball({-10.0, 0.0});
  pitch.add_opponent(9, {-9.7, 0.0}, 180.0);
  const auto block = [&](double speed) {
    pitch.set_parameter("block_speed", speed);
    return block_point(pitch.world).value_or(Vec2{}).x;
  };
  EXPECT_LT(block(1.0), block(0.5) - 2.0) << "a fast one is met nearer to our goal";
}

TEST(PlannerParameters, ChangeWhoIsMarked) {
  KnownPitch pitch;
  pitch.place_ball({-20.0, 25.0});
  pitch.add_opponent(8, {-20.3, 25.0});
  pitch.place_self({-36.0, -3.0});
  pitch.world.unum = 2;
  pitch.add_opponent(11, {-35.0, -3.0});
  const player::TeamPoints homes = home_positions(pitch.world);
  const auto mark = [&] {
    return find_mark(pitch.world, homes, marking_in_open_play(pitch.world));
  };

  ASSERT_TRUE(mark());
  const double usual = mark()->point.x;
  pitch.set_parameter("mark_step", 4.0);
  EXPECT_LT(mark()->point.x, usual - 2.0);

  pitch.set_parameter("mark_range", 10.0);
  EXPECT_FALSE(mark());
  pitch.set_parameter("mark_range", 38.0);
  pitch.set_parameter("mark_way", 0.1);

  EXPECT_FALSE(mark());
  pitch.set_parameter("mark_way", 11.0);
  pitch.set_parameter("mark_ball_x", -40.0);
  EXPECT_FALSE(mark());
}

TEST(PlannerParameters, LetDefendersRunBackWhenTheyArePassed) {
  KnownPitch pitch;
  pitch.world.unum = 4;
  pitch.place_self({-10.0, 20.0}, 180.0);
  pitch.place_ball({-25.0, 22.0});
  pitch.add_opponent(11, {-25.3, 22.0});
  pitch.set_stamina(4500.0);
  bool recovering = true;
  const auto power = [&] { return normal_dash_power(pitch.world, recovering); };
  const double max = pitch.world.server().max_dash_power;

  EXPECT_LT(power(), max);
  pitch.set_parameter("chase_stamina", 0.4);
  EXPECT_EQ(power(), max);
  pitch.set_stamina(3100.0);
  EXPECT_LT(power(), max) << "tired";
  pitch.set_stamina(4500.0);
  pitch.world.unum = 9;
  EXPECT_LT(power(), max) << "a forward";
}

/// Shots in the goal of 13 from `from`, after the goalie had time to take its place.
int goals(Vec2 from, double across) {
  const auto keep = [](protos::PlayerActions& reply) {
    reply.add_actions()->mutable_helios_goalie();
  };
  int count = 0;
  for (double aim = -6.0; aim <= 6.0; aim += 1.0) {
    KnownPitch pitch;
    pitch.set_parameter("goalie_across", across);
    pitch.make_goalie();
    pitch.place_self({-50.0, 0.0});
    pitch.add_opponent(11, from + Vec2{0.4, 0.0});
    for (int cycle = 0; cycle < 20; ++cycle) {
      pitch.place_ball(from);
      pitch.act(keep);
    }
    pitch.place_ball(from, soccer::with_length(Vec2{-52.5, aim} - from, 2.8));
    const auto is_over = [&] { return pitch.world.game.mode != soccer::PlayMode::kPlayOn; };
    pitch.act_until(25, keep, is_over);
    const auto mode = pitch.world.game.mode;
    if (mode == soccer::PlayMode::kGoalRight || mode == soccer::PlayMode::kGoalLeft) ++count;
  }
  return count;
}

TEST(PlannerParameters, LetAGoalieAcrossTheShotSaveMore) {
  int usual = 0;
  int across = 0;
  for (const Vec2 from :
       {Vec2{-40.0, 0.0}, Vec2{-42.0, 8.0}, Vec2{-46.0, -12.0}, Vec2{-38.0, 5.0}}) {
    usual += goals(from, 0.0);
    across += goals(from, 1.0);
  }
  EXPECT_LT(across, usual - usual / 10);
}

TEST(PlannerParameters, ChangeTackles) {
  const auto tackle = [](Vec2 self, Vec2 opponent, double opponent_body, std::string_view name,
                         double value) {
    KnownPitch pitch;
    pitch.place_self(self, opponent.x > 0.0 ? 0.0 : 180.0);
    pitch.place_ball(self + Vec2{opponent.x > 0.0 ? 1.4 : -1.4, 0.0});
    pitch.add_opponent(9, self + opponent, opponent_body);
    pitch.set_parameter(name, value);
    pitch.act(
        [](protos::PlayerActions& reply) { reply.add_actions()->mutable_helios_basic_move(); });
    const auto* sent = pitch.sent<soccer::Tackle>();
    return sent == nullptr ? std::optional<bool>() : sent->foul;
  };

  const Vec2 midfield{0.0, 3.0};
  EXPECT_EQ(tackle(midfield, {0.9, 0.1}, 10.0, "fouls", 1.0), true);
  EXPECT_EQ(tackle(midfield, {0.9, 0.1}, 10.0, "fouls", 0.0), false);
  EXPECT_EQ(tackle(midfield, {0.9, 0.1}, 10.0, "tackle_chance", 1.0), std::nullopt);

  const Vec2 before_goal{-45.0, 3.0};
  EXPECT_EQ(tackle(before_goal, {-0.9, 0.1}, 175.0, "area_back_angle", 100.0), false);
  EXPECT_EQ(tackle(before_goal, {-0.9, 0.1}, 175.0, "area_back_angle", 0.0), std::nullopt);
}

/// The agent has this share of what an even pace needs.
void set_stamina_share(KnownPitch& pitch, double share) {
  const soccer::ServerParams& server = pitch.world.server();
  const double half = server.half_time_cycles();
  const double left = half - pitch.world.game.time.cycle;
  const double even = (server.stamina_max + server.stamina_capacity) * left / half;
  pitch.world.self.capacity = share * even - pitch.world.self.stamina;
}

TEST(PlannerParameters, ChangePaceAndRestingOfRuns) {
  KnownPitch pitch;
  pitch.set_time(1500);
  pitch.place_ball({-20.0, 0.0});
  bool recovering = false;
  const auto power = [&] { return normal_dash_power(pitch.world, recovering); };
  pitch.set_parameter("pace", 0.0);
  set_stamina_share(pitch, 0.5);

  EXPECT_DOUBLE_EQ(running_pace(pitch.world), 1.0) << "the same at all times";
  const double usual = power();
  pitch.set_parameter("pace", 4.0);
  set_stamina_share(pitch, 1.0);
  EXPECT_DOUBLE_EQ(power(), usual);
  set_stamina_share(pitch, 0.95);
  EXPECT_NEAR(power(), 0.8 * usual, 1e-9) << "saves for the end of the half";
  set_stamina_share(pitch, 0.2);
  EXPECT_DOUBLE_EQ(running_pace(pitch.world), 0.5);
  set_stamina_share(pitch, 2.0);
  EXPECT_DOUBLE_EQ(running_pace(pitch.world), 1.3);

  pitch.set_parameter("pace", 0.0);
  EXPECT_DOUBLE_EQ(power(), usual);

  pitch.set_parameter("run_power", 0.85);
  EXPECT_NEAR(power(), 0.5 * usual, 1e-9);
  pitch.set_stamina(4500.0);
  power();

  EXPECT_FALSE(recovering);
  pitch.set_parameter("tired_below", 0.6);
  power();

  EXPECT_TRUE(recovering);
  pitch.set_parameter("tired_below", 0.4);
  pitch.set_parameter("rested_above", 0.5);
  power();
  EXPECT_FALSE(recovering);
}

TEST(Pace, DoesNotDependOnStaminaWithoutLimit) {
  KnownPitch pitch;
  pitch.set_time(2900);
  pitch.set_parameter("pace", 4.0);
  pitch.world.self.capacity = -1.0;
  EXPECT_DOUBLE_EQ(running_pace(pitch.world), 1.0);
}

}  // namespace
}  // namespace cls::proxy
