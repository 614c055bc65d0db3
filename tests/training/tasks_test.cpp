// Every task with every action set and feature set: random play stays within the promised bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/training/stage.h"
#include "training/pool/specification.h"

namespace cls::tests {
namespace {

void expect_within(const std::vector<float>& values, const training::Columns& columns,
                   const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const training::Column& column = columns[i % columns.size()];
    ASSERT_GE(values[i], column.low) << what << " " << column.name;
    ASSERT_LE(values[i], column.high) << what << " " << column.name;
  }
}

void play_randomly(const std::string& config) {
  SCOPED_TRACE(config);
  const auto setup = setup_of(config);
  BoundPool pool(config, 3);
  soccer::RandomStream random(5, "actions");
  for (int i = 0; i < 25; ++i) {
    pool.draw_actions(random);
    ASSERT_EQ(pool.step(), CLS_TRAINING_OK) << cls_training_error();
    expect_within(pool.observations, setup->feature_columns, "feature");
    expect_within(pool.state, setup->state_columns, "state");
  }
}

TEST(TrainingTasks, ObservationsStayWithinTheirBounds) {
  // Every pair of task and action set, with the feature sets in turn.
  std::size_t turn = 0;

  for (const training::Task& task : training::tasks()) {
    for (const training::ActionSet* actions : training::action_sets()) {
      const auto& sets = training::feature_sets();
      const training::FeatureSet* features = sets[turn++ % sets.size()];
      if (features->left_only && task.agents != training::Agents::kLeft) continue;
      if (features->needs_options) features = &training::kEgo2Features;
      const base::Json config = {{"task", task.id},
                                 {"actions", actions->name},
                                 {"features", features->name},
                                 {"obs", actions->options ? "world_model" : "full_state"},
                                 {"autoreset", "same_step"}};
      play_randomly(config.dump());
    }
  }
}

TEST(TrainingTasks, ObservationsOfATeamStayWithinTheirBounds) {
  play_randomly(R"({"task": "Match", "obs": "world_model", "actions": "options",)"
                R"( "features": "team", "agents": "both", "autoreset": "same_step"})");
}

TEST(TrainingTasks, BothTeamsCanBeAgents) {
  play_randomly(R"({"task": "HalfFieldOffense", "offense": 2, "defense": 3, "agents": "both",)"
                R"( "features": "ego", "actions": "hfo", "autoreset": "same_step"})");
}

TEST(TrainingTasks, HeldOpponentsStand) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "defense": 2, "opponent": "hold"})", 3);
  const cls_training_world before = pool.view();
  for (int i = 0; i < 20; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  const cls_training_world after = pool.view();
  EXPECT_NEAR(before.players[12].x, after.players[12].x, 1e-9);
}

// Positions of Google Research Football in its scale, x -1..1 and y -0.42..0.42, of the right team
// as that team sees them.
TEST(TrainingTasks, AcademyStartsAtTheOriginalPlaces) {
  struct Case {
    const char* task;
    int players[2];
    double ball[2];
    double second_left[2];
    double second_right[2];
  };

  const std::vector<Case> cases = {
      {"3Vs1WithKeeper", {3, 2}, {0.62, 0.0}, {0.7, 0.2}, {-0.75, 0.0}},
      {"Corner", {11, 11}, {0.99, 0.41}, {1.0, 0.42}, {-0.75, -0.18}},
      {"CounterattackEasy", {11, 11}, {0.26, -0.11}, {-0.672, -0.19576}, {0.128, -0.19576}},
      {"PassAndShootWithKeeper", {2, 2}, {0.7, -0.28}, {0.7, -0.3}, {-0.75, 0.3}},
      {"SingleGoalVersusLazy", {11, 11}, {-0.48, -0.06356}, {0.0, 0.02}, {-0.05, 0.0}}};

  for (const Case& one : cases) {
    SCOPED_TRACE(one.task);
    const std::string id = std::string("Academy-") + one.task;
    BoundPool pool(R"({"task": ")" + id + R"(", "options": {"difficulty": 0}})", 1);
    const cls_training_world world = pool.view();
    const auto x = [](double value) { return value * 52.5; };
    const auto y = [](double value) { return value / 0.42 * 34.0; };
    EXPECT_NEAR(world.ball_x, x(one.ball[0]), 1e-9);
    EXPECT_NEAR(world.ball_y, y(one.ball[1]), 1e-9);
    EXPECT_NEAR(world.players[1].x, x(one.second_left[0]), 1e-9);
    EXPECT_NEAR(world.players[1].y, y(one.second_left[1]), 1e-9);
    EXPECT_NEAR(world.players[12].x, -x(one.second_right[0]), 1e-9);
    EXPECT_NEAR(world.players[12].y, -y(one.second_right[1]), 1e-9);
    int players[2] = {0, 0};
    for (const cls_training_player& player : world.players) {
      if (player.on_pitch != 0) ++players[player.side > 0 ? 0 : 1];
    }
    EXPECT_EQ(players[0], one.players[0]);
    EXPECT_EQ(players[1], one.players[1]);
  }
}

TEST(TrainingTasks, LazyOpponentsStandButTheirGoalie) {
  BoundPool pool(R"({"task": "Academy-SingleGoalVersusLazy", "options": {"difficulty": 0}})", 1);
  const cls_training_world before = pool.view();
  for (int i = 0; i < 30; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  const cls_training_world after = pool.view();
  int moved = 0;
  for (int slot = 11; slot < 22; ++slot) {
    const bool away = std::abs(after.players[slot].x - before.players[slot].x) > 0.01;
    EXPECT_EQ(away, after.players[slot].goalie == 1) << slot;
    moved += away ? 1 : 0;
  }
  EXPECT_EQ(moved, 1);
}

TEST(TrainingTasks, ReachingTheBallEndsReachBall) {
  BoundPool pool(R"({"task": "ReachBall", "actions": "hfo"})", 3);
  pool.action_ids[0] = 18;
  while (pool.status[0] == CLS_TRAINING_IN_GAME) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_EQ(pool.status[0], CLS_TRAINING_REACHED);
  EXPECT_EQ(pool.terminated[0], 1);
  EXPECT_FLOAT_EQ(pool.rewards[0], 1.0F);
}

TEST(TrainingTasks, DifficultyMovesTheStart) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "num_envs": 2})");
  ASSERT_EQ(cls_training_set_options(pool.handle, 1, R"({"difficulty": 0})"), CLS_TRAINING_OK);
  ASSERT_EQ(pool.reset(3), CLS_TRAINING_OK);
  EXPECT_LT(pool.view(0).ball_x, 11.0);
  EXPECT_GT(pool.view(1).ball_x, 40.0);
}

TEST(TrainingTasks, MatchKicksOffAndGoesOnAfterGoals) {
  BoundPool pool(R"({"task": "Match", "num_agents": 1, "opponent": "hold"})", 1);
  pool.action_ids[0] = 13;
  for (int i = 0; i < 1200; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  const cls_training_world world = pool.view();
  EXPECT_GT(world.time, 800);
  EXPECT_GT(world.score[0], 0) << "scripted players against standing ones";
  EXPECT_EQ(pool.status[0], CLS_TRAINING_IN_GAME);
}

TEST(TrainingTasks, CatalogListsEverything) {
  const base::Json catalog = training::catalog();
  EXPECT_EQ(catalog["schema"], "cls.training.catalog/1");
  EXPECT_EQ(catalog["tasks"].size(), 17U);
  EXPECT_EQ(catalog["statuses"][1]["name"], "GOAL");
  for (const auto& task : catalog["tasks"]) EXPECT_EQ(task["options"][0]["name"], "difficulty");
}

}  // namespace
}  // namespace cls::tests
