// Parameters of the planner: their table, and what they change.
#include "proxy/world/planner_parameters.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>
#include <vector>

#include "proxy/movement/home_positions.h"
#include "proxy/planner/evaluation.h"
#include "proxy/planner/generators.h"
#include "proxy/planner/outlet.h"
#include "tests/proxy/support/known_pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;
using tests::KnownPitch;

/// The agent plays with this value from now on.
void set(KnownPitch& pitch, std::string_view name, double value) {
  auto parameters = std::make_shared<PlannerParameters>(*pitch.world.planner);
  ASSERT_TRUE(set_planner_parameter(*parameters, name, value)) << name;
  pitch.world.planner = std::move(parameters);
}

TEST(PlannerParameters, HaveDistinctNamesAndDefaultsWithinTheirRange) {
  const PlannerParameters defaults;
  std::set<std::string_view> names;
  for (const PlannerParameter& row : planner_parameter_table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_GE(value_of(defaults, row), row.low) << row.name;
    EXPECT_LE(value_of(defaults, row), row.high) << row.name;
    EXPECT_LT(row.low, row.high) << row.name;
  }
}

TEST(PlannerParameters, SetsOnlyTheNamedOne) {
  for (const PlannerParameter& row : planner_parameter_table()) {
    PlannerParameters parameters;
    ASSERT_TRUE(set_planner_parameter(parameters, row.name, row.high)) << row.name;
    for (const PlannerParameter& other : planner_parameter_table()) {
      const double expected =
          other.name == row.name ? row.high : value_of(PlannerParameters(), other);
      EXPECT_EQ(value_of(parameters, other), expected) << row.name << " and " << other.name;
    }
  }
}

TEST(PlannerParameters, RefusesWrongNamesAndValues) {
  PlannerParameters parameters;
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
  Plan plan;
  PlanNode node;
  node.holder = 7;
  node.depth = 3;
  node.ball = {10.0, 0.0};
  node.time = 12;
  plan.nodes.push_back(node);
  const auto value = [&] { return default_value(PlannerField(pitch.world), plan, 0); };
  const double usual = value();
  const auto change = [&](std::string_view name, double to) {
    const auto before = pitch.world.planner;
    set(pitch, name, to);
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
}

TEST(PlannerParameters, ChangeWhichPassesAreGenerated) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {46.0, -30.0});
  pitch.add_opponent(4, {10.0, 4.0});
  pitch.add_teammate(9, {16.0, 9.0});
  const auto passes = [&] {
    std::vector<PlanAction> actions;
    add_passes(PlannerField(pitch.world), actions);
    return actions.size();
  };
  const std::size_t usual = passes();
  set(pitch, "pass_margin", 3.0);
  EXPECT_LT(passes(), usual);
  set(pitch, "pass_margin", 0.0);
  EXPECT_GT(passes(), usual);
  set(pitch, "pass_distance", 10.0);
  EXPECT_EQ(passes(), 0U);
}

TEST(PlannerParameters, ChangeOutlets) {
  KnownPitch pitch;
  pitch.place_self({-45.0, 0.0});
  pitch.place_ball({-44.5, 0.0});
  pitch.add_teammate(6, {-30.0, 20.0}, 180.0);
  EXPECT_TRUE(best_outlet(PlannerField(pitch.world))->teammate_first);
  set(pitch, "outlet_gain", 0.0);
  set(pitch, "outlet_kick_in", 100.0);
  EXPECT_FALSE(best_outlet(PlannerField(pitch.world))->teammate_first);
}

TEST(PlannerParameters, ShiftHomePositionsOfFieldPlayers) {
  KnownPitch pitch;
  pitch.place_ball({0.0, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(2, {48.0, 0.0});
  ASSERT_EQ(formation_kind(pitch.world), FormationKind::kOffense);
  const TeamPoints usual = home_positions(pitch.world);
  set(pitch, "shift_offense", 4.0);
  set(pitch, "shift_defense", -20.0);
  const TeamPoints shifted = home_positions(pitch.world);
  EXPECT_EQ(shifted[0].x, usual[0].x) << "the goalie stays";
  for (std::size_t i = 1; i < usual.size(); ++i) {
    EXPECT_NEAR(shifted[i].x, usual[i].x + 4.0, 1e-9) << i + 1;
    EXPECT_EQ(shifted[i].y, usual[i].y);
  }
}

}  // namespace
}  // namespace cls::proxy
