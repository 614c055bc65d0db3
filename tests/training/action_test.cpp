// Action sets: ids, parameters, legality and effect.
#include "training/actions/action_set.h"

#include <gtest/gtest.h>

#include "tests/training/stage.h"

namespace cls::tests {
namespace {

using soccer::Vec2;

TEST(TrainingActions, HfoHasItsTwentyIdsAndParameters) {
  const std::vector<std::pair<std::string, std::size_t>> expected = {
      {"DASH", 2},        {"TURN", 1},        {"TACKLE", 1},     {"KICK", 2},
      {"KICK_TO", 3},     {"MOVE_TO", 2},     {"DRIBBLE_TO", 2}, {"INTERCEPT", 0},
      {"MOVE", 0},        {"SHOOT", 0},       {"PASS", 1},       {"DRIBBLE", 0},
      {"CATCH", 0},       {"NOOP", 0},        {"QUIT", 0},       {"REDUCE_ANGLE_TO_GOAL", 0},
      {"MARK_PLAYER", 1}, {"DEFEND_GOAL", 0}, {"GO_TO_BALL", 0}, {"REORIENT", 0}};
  const std::vector<training::Action>& actions = training::hfo_actions().actions;
  ASSERT_EQ(actions.size(), expected.size());
  for (std::size_t id = 0; id < expected.size(); ++id) {
    EXPECT_EQ(actions[id].name, expected[id].first);
    EXPECT_EQ(actions[id].parameters.size(), expected[id].second) << expected[id].first;
  }
}

TEST(TrainingActions, DiscreteSetHas81Ids) {
  EXPECT_EQ(training::low_discrete_actions().id_count(), 81);
  EXPECT_TRUE(training::low_discrete_actions().values().empty());
}

/// One attacker without opponents whose action is repeated.
class OneAttacker : public testing::Test {
 protected:
  OneAttacker()
      : pool_(R"({"task": "HalfFieldOffense", "actions": "hfo", "max_cycles": 400,)"
              R"( "options": {"offense_on_ball": 1}})") {
    EXPECT_EQ(pool_.reset(4), CLS_TRAINING_OK);
  }

  int id(std::string_view name) const {
    const auto& actions = training::hfo_actions().actions;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (actions[i].name == name) return static_cast<int>(i);
    }
    return -1;
  }

  void repeat(std::string_view name, int steps) {
    pool_.action_ids[0] = id(name);
    for (int i = 0; i < steps && pool_.status[0] == CLS_TRAINING_IN_GAME; ++i) {
      ASSERT_EQ(pool_.step(), CLS_TRAINING_OK) << cls_training_error();
    }
  }

  cls_training_world view() const {
    cls_training_world world = {};
    world.struct_size = sizeof world;
    EXPECT_EQ(cls_training_view(pool_.handle, 0, &world), CLS_TRAINING_OK);
    return world;
  }

  BoundPool pool_;
};

TEST_F(OneAttacker, ShootNeedsTheBall) {
  EXPECT_EQ(pool_.action_masks[static_cast<std::size_t>(id("SHOOT"))], 1);
  repeat("SHOOT", 1);
  const cls_training_world world = view();
  EXPECT_GT(world.ball_vx, 1.0);
  repeat("NOOP", 3);
  EXPECT_EQ(pool_.action_masks[static_cast<std::size_t>(id("SHOOT"))], 0);
  repeat("SHOOT", 1);
  EXPECT_EQ(pool_.illegal[0], 1);
}

TEST_F(OneAttacker, DribblingScores) {
  while (pool_.status[0] == CLS_TRAINING_IN_GAME) {
    const cls_training_world world = view();
    repeat(world.ball_x > 40.0 && pool_.action_masks[static_cast<std::size_t>(id("SHOOT"))] == 1
               ? "SHOOT"
           : world.ball_x > 40.0 ? "INTERCEPT"
                                 : "DRIBBLE",
           1);
    if (pool_.action_masks[static_cast<std::size_t>(id("DRIBBLE"))] == 0) repeat("INTERCEPT", 1);
  }
  EXPECT_EQ(pool_.status[0], CLS_TRAINING_GOAL);
  EXPECT_EQ(pool_.score[0], 1);
}

TEST_F(OneAttacker, MoveToReachesItsTarget) {
  // Of HFO's scale: x from -5.25 to 57.75, y from -37.4 to 37.4.
  const std::vector<int> offsets = training::hfo_actions().offsets();
  const auto first = static_cast<std::size_t>(offsets[static_cast<std::size_t>(id("MOVE_TO"))]);
  pool_.action_values[first] = 0.0F;
  pool_.action_values[first + 1] = 0.2F;
  repeat("MOVE_TO", 100);
  const cls_training_player& me = view().players[10];
  EXPECT_NEAR(me.x, 26.25, 1.0);
  EXPECT_NEAR(me.y, 7.48, 1.0);
}

TEST_F(OneAttacker, ReorientFacesTheBall) {
  repeat("GO_TO_BALL", 1);
  repeat("REORIENT", 3);
  const cls_training_world world = view();
  const cls_training_player& me = world.players[10];
  const double bearing = soccer::direction_degrees(Vec2{world.ball_x - me.x, world.ball_y - me.y});
  EXPECT_LT(std::abs(soccer::math::normalize_degrees(bearing - me.body)), 20.0);
}

}  // namespace
}  // namespace cls::tests
