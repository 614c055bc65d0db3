// Action sets: ids, parameters, legality and effect.
#include "training/actions/action_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/index.h"
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

// Masks ask each condition once; the answer is that of each action.
TEST(TrainingActions, LegalityIsThatOfEachAction) {
  for (const training::ActionSet* set : training::action_sets()) {
    if (set->actions.empty() || set->options) continue;
    const auto setup = setup_of(R"({"task": "Match", "actions": ")" + std::string(set->name) +
                                R"(", "features": "ego", "autoreset": "same_step"})");
    training::Episode episode(setup);
    episode.reset(5, setup->options);
    const training::Legality legality(*set);
    soccer::RandomStream random(3, "legality");
    std::vector<std::uint8_t> mask(set->actions.size());
    std::set<std::vector<std::uint8_t>> different;

    for (int round = 0; round < 200; ++round) {
      simulator::World world = episode.world();
      simulator::Player& player = world.player(random.integer(soccer::kPlayersPerTeam));
      world.ball.position =
          player.position + Vec2{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
      training::Scene scene;
      training::fill_scene(world, soccer::Side::kLeft, setup->cast, scene);
      const training::PointOfView view = {scene, setup->cast, player.slot(),
                                          setup->task->stage(soccer::Side::kLeft)};
      legality.fill(view, mask.data());
      for (std::size_t id = 0; id < mask.size(); ++id) {
        const training::Condition legal = set->actions[id].legal;
        EXPECT_EQ(mask[id] != 0, legal == nullptr || legal(view)) << set->actions[id].name;
      }
      different.insert(mask);
    }
    EXPECT_GT(different.size(), 1U) << set->name;
  }
}

// Trained policies know actions by number.
TEST(TrainingActions, KeepTheirNumbers) {
  const std::vector<training::Action>& low = training::low_discrete_actions().actions;
  for (const auto& [id, name] : {std::pair{0, "noop"},
                                 {4, "dash_100_-135"},
                                 {17, "turn_-120"},
                                 {29, "kick_50_1"},
                                 {80, "tackle_135"}}) {
    EXPECT_EQ(low[base::index(id)].name, name);
  }

  const std::vector<training::Action>& skills = training::skill_actions().actions;
  ASSERT_EQ(skills.size(), 83U);

  for (const auto& [id, name] : {std::pair{1, "shoot"},
                                 {9, "pass_1"},
                                 {20, "kick_hard_0"},
                                 {51, "dribble_0"},
                                 {82, "run_15"}}) {
    EXPECT_EQ(skills[base::index(id)].name, name);
  }
}

TEST(TrainingActions, HaveNamesOfTheirOwn) {
  for (const training::ActionSet* set : training::action_sets()) {
    std::set<std::string_view> names;
    for (const training::Action& action : set->actions) names.insert(action.name);
    EXPECT_EQ(names.size(), set->actions.size()) << set->name;
  }
}

int id_of(const training::ActionSet& set, std::string_view name) {
  return static_cast<int>(std::ranges::find(set.actions, name, &training::Action::name) -
                          set.actions.begin());
}

/// One attacker without opponents whose action is repeated.
class OneAttacker : public testing::Test {
 protected:
  explicit OneAttacker(const training::ActionSet& set = training::hfo_actions())
      : set_(set),
        pool_(R"({"task": "HalfFieldOffense", "max_cycles": 400,)"
              R"( "options": {"offense_on_ball": 1}, "actions": ")" +
              std::string(set.name) + R"("})") {
    EXPECT_EQ(pool_.reset(4), CLS_TRAINING_OK);
  }

  int id(std::string_view name) const { return id_of(set_, name); }

  void repeat(std::string_view name, int steps) {
    pool_.action_ids[0] = id(name);
    for (int i = 0; i < steps && pool_.status[0] == CLS_TRAINING_IN_GAME; ++i) {
      ASSERT_EQ(pool_.step(), CLS_TRAINING_OK) << cls_training_error();
    }
  }

  cls_training_world view() const { return pool_.view(); }

  bool is_legal(std::string_view name) const {
    return pool_.action_masks[base::index(id(name))] == 1;
  }

  const training::ActionSet& set_;
  BoundPool pool_;
};

class OneSkilledAttacker : public OneAttacker {
 protected:
  OneSkilledAttacker() : OneAttacker(training::skill_actions()) {}
};

TEST_F(OneAttacker, ShootNeedsTheBall) {
  EXPECT_TRUE(is_legal("SHOOT"));
  repeat("SHOOT", 1);
  EXPECT_GT(view().ball_vx, 1.0);
  repeat("NOOP", 3);
  EXPECT_FALSE(is_legal("SHOOT"));
  repeat("SHOOT", 1);
  EXPECT_EQ(pool_.illegal[0], 1);
}

TEST_F(OneAttacker, DribblingScores) {
  while (pool_.status[0] == CLS_TRAINING_IN_GAME) {
    const cls_training_world world = view();
    repeat(world.ball_x > 40.0 && is_legal("SHOOT") ? "SHOOT"
           : world.ball_x > 40.0                    ? "INTERCEPT"
                                                    : "DRIBBLE",
           1);
    if (!is_legal("DRIBBLE")) repeat("INTERCEPT", 1);
  }
  EXPECT_EQ(pool_.status[0], CLS_TRAINING_GOAL);
  EXPECT_EQ(pool_.score[0], 1);
}

TEST_F(OneAttacker, MoveToReachesItsTarget) {
  // Targets have HFO's scale: x from -5.25 to 57.75, y from -37.4 to 37.4.
  const std::vector<int> offsets = training::hfo_actions().offsets();
  const auto first = base::index(offsets[base::index(id("MOVE_TO"))]);
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

TEST_F(OneSkilledAttacker, KeepsTheBallNearWhileItDribbles) {
  const double start = view().ball_x;
  double farthest = 0.0;
  for (int cycle = 0; cycle < 40; ++cycle) {
    repeat("dribble_8", 1);
    const cls_training_world world = view();
    const cls_training_player& me = world.players[10];
    farthest = std::max(farthest, std::hypot(world.ball_x - me.x, world.ball_y - me.y));
  }
  EXPECT_LT(farthest, 3.0);
  EXPECT_GT(view().ball_x - start, 20.0);
  EXPECT_EQ(pool_.illegal[0], 0);
}

TEST_F(OneSkilledAttacker, StopsTheBall) {
  repeat("kick_soft_8", 1);
  repeat("take_ball", 25);
  const cls_training_world world = view();
  EXPECT_LT(std::hypot(world.ball_vx, world.ball_vy), 0.1);
  EXPECT_TRUE(is_legal("shoot"));
}

TEST_F(OneSkilledAttacker, HasNoOneToPassToOrToMark) {
  EXPECT_TRUE(is_legal("kick_hard_8"));
  EXPECT_FALSE(is_legal("pass_1"));
  EXPECT_FALSE(is_legal("mark"));
  EXPECT_FALSE(is_legal("catch"));
}

TEST(TrainingSkills, PassReachesTheTeammate) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "offense": 2, "actions": "skills",)"
                 R"( "options": {"offense_on_ball": 1}})");
  const auto id = [](std::string_view name) { return id_of(training::skill_actions(), name); };

  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_EQ(pool.reset(seed), CLS_TRAINING_OK);
    const bool first = pool.action_masks[base::index(id("pass_1"))] == 1;
    const std::size_t passer = first ? 0 : 1;
    const std::size_t mate = 1 - passer;
    pool.action_ids[passer] = id("pass_1");
    pool.action_ids[mate] = id("take_ball");
    const auto shoot = mate * pool.ids + base::index(id("shoot"));
    int cycles = 0;
    while (pool.action_masks[shoot] == 0 && cycles < 60) {
      ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
      ++cycles;
    }
    EXPECT_LT(cycles, 60) << "seed " << seed;
  }
}

}  // namespace
}  // namespace cls::tests
