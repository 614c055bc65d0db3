// Feature sets: sizes, bounds, symmetry.
#include "training/features/feature_set.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "soccer/math.h"
#include "tests/training/stage.h"
#include "training/scene/openings.h"

namespace cls::tests {
namespace {

using soccer::Vec2;

TEST(TrainingFeatures, HfoSetsHaveHfosSizes) {
  for (int t = 0; t <= 4; ++t) {
    for (int o = 0; o <= 5; ++o) {
      EXPECT_EQ(training::kHfoLowFeatures.columns(t, o).size(),
                static_cast<std::size_t>(59 + 9 * t + 9 * o));
      EXPECT_EQ(training::kHfoHighFeatures.columns(t, o).size(),
                static_cast<std::size_t>(12 + 6 * t + 3 * o));
    }
  }
}

TEST(TrainingFeatures, NamesAreUnique) {
  for (const training::FeatureSet* set : training::feature_sets()) {
    std::set<std::string> names;
    for (const training::Column& column : set->columns(3, 4)) {
      EXPECT_TRUE(names.insert(column.name).second) << set->name << ": " << column.name;
    }
  }
}

// Position and body of the agent, ball and opponents are mirrored for the right team: a world that
// is rotated by 180 degrees looks the same from the other side.
TEST(TrainingFeatures, TeamsSeeMirroredWorldsAlike) {
  const auto setup = setup_of(
      R"({"task": "Match", "offense": 2, "defense": 2, "agents": "both", "features": "ego"})");
  simulator::World world = setup->prepared;

  for (const int slot : setup->cast.left) {
    const int twin = slot + soccer::kPlayersPerTeam;
    simulator::Player& left = world.player(slot);
    simulator::Player& right = world.player(twin);
    left.position = {10.0 + slot, 5.0};
    left.velocity = {0.3, 0.1};
    left.body = 0.5 + slot;
    right.position = -left.position;
    right.velocity = -left.velocity;
    right.body = soccer::math::normalize_radians(left.body + soccer::math::kPi);
    right.goalie = left.goalie;
  }

  std::array<training::Scene, 2> scenes;
  std::array<std::vector<float>, 2> seen;

  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const soccer::Side side = i == 0 ? soccer::Side::kLeft : soccer::Side::kRight;
    training::fill_scene(world, side, setup->cast, scenes[i]);
    training::complete_for_observers(scenes[i]);
    seen[i].resize(setup->feature_count());
    training::kEgoFeatures.fill({scenes[i], setup->cast, 0, setup->task->stage(side)},
                                seen[i].data());
  }

  for (std::size_t i = 0; i < seen[0].size(); ++i) {
    EXPECT_NEAR(seen[0][i], seen[1][i], 1e-6) << setup->feature_columns[i].name;
  }
}

TEST(TrainingFeatures, VersionsAreFoundByName) {
  EXPECT_EQ(training::find_feature_set("ego"), &training::kEgoFeatures);
  EXPECT_EQ(training::find_feature_set("ego/1"), &training::kEgoFeatures);
  EXPECT_EQ(training::find_feature_set("ego/2"), &training::kEgo2Features);
  EXPECT_EQ(training::find_feature_set("ego/3"), nullptr);
}

/// Where a column of the setup's features is.
std::size_t column(const training::Setup& setup, const std::string& name) {
  const auto found = std::ranges::find(setup.feature_columns, name, &training::Column::name);
  EXPECT_NE(found, setup.feature_columns.end()) << name;
  return static_cast<std::size_t>(found - setup.feature_columns.begin());
}

TEST(TrainingFeatures, Ego2BeginsWithEgoAndHasModeConditionAndOffsideLine) {
  const auto setup = setup_of(
      R"({"task": "Match", "offense": 2, "defense": 3, "agents": "both", "features": "ego/2"})");
  simulator::World world = setup->prepared;
  world.mode = soccer::PlayMode::kCornerKickRight;
  world.ball.position = {-30.0, 2.0};
  for (const int slot : setup->cast.left) world.player(slot).position = {-10.0 - slot, 3.0};
  for (const int slot : setup->cast.right) world.player(slot).position = {10.0 + slot, 3.0};
  world.player(setup->cast.left[0]).stamina.effort = 0.75;

  training::Scene scene;
  training::fill_scene(world, soccer::Side::kLeft, setup->cast, scene);
  training::complete_for_observers(scene);
  std::vector<float> one(training::kEgoFeatures.columns(1, 3).size());
  std::vector<float> two(training::kEgo2Features.columns(1, 3).size());
  const training::PointOfView view{scene, setup->cast, setup->cast.left[0],
                                   setup->task->stage(soccer::Side::kLeft)};
  training::kEgoFeatures.fill(view, one.data());
  training::kEgo2Features.fill(view, two.data());

  EXPECT_TRUE(std::equal(one.begin(), one.end(), two.begin()));
  EXPECT_EQ(two[column(*setup, "self_effort")], 0.75F);
  EXPECT_EQ(two[column(*setup, "mode_corner_kick")], 1.0F);
  EXPECT_EQ(two[column(*setup, "mode_kick_in")], -1.0F);
  EXPECT_EQ(two[column(*setup, "mode_own")], -1.0F);
  EXPECT_EQ(two[column(*setup, "opponent1_age")], 0.0F);
  EXPECT_GT(two[column(*setup, "opponent3_speed_max")], 0.5F);

  std::vector<double> xs;
  for (const int slot : setup->cast.right) xs.push_back(world.player(slot).position.x);
  std::ranges::sort(xs);
  EXPECT_FLOAT_EQ(two[column(*setup, "offside_line_x")],
                  static_cast<float>(xs[xs.size() - 2] / soccer::kHalfLength));
}

TEST(TrainingFeatures, Ego2HasTheAgesOfAWorldModel) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "features": "ego/2",
                     "obs": "world_model", "actions": "low_discrete"})",
                 3);
  const auto setup =
      setup_of(R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "features": "ego/2"})");
  soccer::RandomStream random(1, "ages");
  float oldest = 0.0F;
  for (int step = 0; step < 40; ++step) {
    pool.play(random, 1);
    for (const char* name : {"opponent1_age", "opponent2_age", "teammate1_age"}) {
      const float age = pool.observations[column(*setup, name)];
      EXPECT_GE(age, 0.0F);
      EXPECT_LE(age, 1.0F);
      oldest = std::max(oldest, age);
    }
  }
  EXPECT_GT(oldest, 0.0F) << "somebody was out of sight";
}

TEST(TrainingFeatures, Ego2CountsCyclesSinceTheModeChangedAndKnowsTheLastToucher) {
  for (const char* obs : {"full_state", "world_model"}) {
    const std::string config = fmt::format(
        R"({{"task": "Match", "offense": 2, "defense": 2, "actions": "hfo", "features": "ego/2",
            "obs": "{}"}})",
        obs);
    BoundPool pool(config, 3);
    const auto setup = setup_of(config);
    const std::size_t age = column(*setup, "mode_age");
    const std::size_t by_own = column(*setup, "touched_by_own");
    soccer::RandomStream random(1, "modes");
    int changes = 0;
    int touches = 0;
    for (int step = 0; step < 300 && pool.status[0] == CLS_TRAINING_IN_GAME; ++step) {
      const std::string mode = pool.view().play_mode;
      const float before = pool.observations[age];
      pool.play(random, 1);

      const bool changed = mode != pool.view().play_mode;
      const float expected = changed ? 0.0F : std::min(before + 0.01F, 1.0F);
      EXPECT_NEAR(pool.observations[age], expected, 0.011F) << obs << step << mode;
      changes += changed ? 1 : 0;
      touches += pool.observations[by_own] != 0.0F ? 1 : 0;
    }
    EXPECT_GT(changes, 0) << obs;
    EXPECT_GT(touches, 0) << obs;
  }
}

TEST(TrainingFeatures, StateVersion2BeginsWithVersion1) {
  BoundPool one(R"({"task": "Match", "offense": 2, "defense": 2, "actions": "low_discrete"})", 3);
  BoundPool two(
      R"({"task": "Match", "offense": 2, "defense": 2, "actions": "low_discrete", "state": 2})", 3);
  ASSERT_GT(two.states, one.states);
  soccer::RandomStream first(1, "state");
  soccer::RandomStream second(1, "state");
  for (int step = 0; step < 60; ++step) {
    one.play(first, 1);
    two.play(second, 1);
    ASSERT_TRUE(std::equal(one.state.begin(), one.state.end(), two.state.begin())) << step;
  }
  EXPECT_THROW(setup_of(R"({"task": "Match", "state": 3})"), std::runtime_error);
}

// The definition, observer by observer.
double plain_opening(const training::Scene& scene, const training::Cast& cast, Vec2 eye, double low,
                     double high, double reach) {
  std::vector<std::pair<double, double>> covered;
  for (const training::Seat seat : training::seats_of(scene.side, cast.others(scene.side))) {
    const Vec2 to = scene.player(seat).position - eye;
    if (!scene.player(seat).seen || to.length() >= reach) continue;
    const double half = soccer::math::atan2(1.085 * 0.5, to.length());
    const double middle = soccer::direction_radians(to);
    if (middle + half >= low && middle - half <= high) {
      covered.emplace_back(middle - half, middle + half);
    }
  }

  std::sort(covered.begin(), covered.end());
  double widest = 0.0;
  double from = low;
  for (const auto& [begin, end] : covered) {
    widest = std::max(widest, begin - from);
    from = std::max(from, end);
  }

  return std::max(widest, high - from);
}

TEST(TrainingFeatures, SharedOpeningsAreThoseOfEachObserver) {
  const auto setup = setup_of(R"({"task": "Match", "features": "hfo_high"})");
  soccer::RandomStream random(4, "openings");
  const double pi = soccer::math::kPi;

  for (int round = 0; round < 50; ++round) {
    simulator::World world = setup->prepared;
    for (simulator::Player& player : world.players) {
      player.position = {random.uniform(-52.0, 52.0), random.uniform(-34.0, 34.0)};
    }
    training::Scene scene;
    training::fill_scene(world, soccer::Side::kLeft, setup->cast, scene);
    const training::Openings openings(scene, setup->cast);

    for (training::Seat eye = 0; eye < soccer::kPlayersPerTeam; ++eye) {
      const Vec2 place = scene.player(eye).position;
      const auto post = [&](double y) {
        return soccer::direction_radians(Vec2{soccer::kHalfLength, y} - place);
      };
      EXPECT_EQ(openings.to_goal(eye),
                plain_opening(scene, setup->cast, place, post(-7.01), post(7.01), 1e9));
      const training::Seat mate = (eye + 1) % soccer::kPlayersPerTeam;
      const Vec2 to = scene.player(mate).position - place;
      const double middle = soccer::direction_radians(to);
      EXPECT_EQ(openings.to_teammate(eye, mate),
                plain_opening(scene, setup->cast, place, middle - pi / 4.0, middle + pi / 4.0,
                              to.length()));

      double nearest = 1e9;
      for (training::Seat seat = soccer::kPlayersPerTeam; seat < training::kSeats; ++seat) {
        nearest = std::min(nearest, distance(scene.player(seat).position, place));
      }
      EXPECT_EQ(openings.nearest_opponent(eye), nearest);
    }
  }
}

TEST(TrainingFeatures, NoOpponentIsNearWhereNoneIsSeen) {
  const auto setup = setup_of(R"({"task": "HalfFieldOffense", "features": "hfo_high"})");
  training::Scene scene;
  training::fill_scene(setup->prepared, soccer::Side::kLeft, setup->cast, scene);
  const training::Openings openings(scene, setup->cast);
  const training::Seat eye = training::seat_of(soccer::Side::kLeft, setup->cast.left.front());
  EXPECT_TRUE(std::isinf(openings.nearest_opponent(eye)));
}

TEST(TrainingFeatures, AttackersOnlySetIsRefusedForDefenders) {
  EXPECT_THROW(setup_of(R"({"task": "HalfFieldDefense", "features": "hfo_low"})"),
               std::runtime_error);
}

}  // namespace
}  // namespace cls::tests
