// Agents that choose where they look and what they say.
#include "training/senses/sense_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/training/stage.h"

namespace cls::tests {
namespace {

std::string sensing(const std::string& more) {
  return R"({"task": "HalfFieldOffense", "num_envs": 2, "offense": 2, "defense": 1, )"
         R"("obs": "world_model", "features": "ego", "actions": "low_discrete")" +
         more + "}";
}

// A pool whose agents choose all their senses, and the columns of their observations.
class SensingPool : public BoundPool {
 public:
  explicit SensingPool(const std::string& more = R"(, "look": true, "say": true)")
      : BoundPool(sensing(more), 3), setup(setup_of(sensing(more))) {}

  void choose(std::size_t agent, std::string_view head, std::string_view item) {
    const auto& heads = setup->sense_heads;
    const auto found = std::ranges::find(heads, head, &training::SenseHead::name);
    const auto number = std::ranges::find(found->items, item) - found->items.begin();
    const std::size_t row = agent * width + 1 + static_cast<std::size_t>(found - heads.begin());
    action_ids[row] = static_cast<std::int32_t>(number);
  }

  float seen(std::size_t agent, const std::string& column) const {
    const auto& columns = setup->feature_columns;
    const auto found = std::ranges::find(columns, column, &training::Column::name);
    EXPECT_NE(found, columns.end()) << column;
    return observations[agent * features + static_cast<std::size_t>(found - columns.begin())];
  }

  void step_often(int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(step(), CLS_TRAINING_OK) << cls_training_error();
  }

  std::shared_ptr<const training::Setup> setup;
};

TEST(TrainingSenses, DefaultsAreThoseOfMatches) {
  BoundPool plain(sensing(""), 3);
  SensingPool sensing;
  EXPECT_EQ(plain.width, 1U);
  EXPECT_EQ(sensing.width, 5U);
  EXPECT_EQ(sensing.features, plain.features + 7 + 12);

  soccer::RandomStream one(8, "actions");
  soccer::RandomStream two(8, "actions");
  for (int i = 0; i < 60; ++i) {
    plain.play(one, 1);
    sensing.play(two, 1);
    for (std::size_t row = 0; row < plain.worlds * plain.agents; ++row) {
      const auto first =
          plain.observations.begin() + static_cast<std::ptrdiff_t>(row * plain.features);
      const auto other =
          sensing.observations.begin() + static_cast<std::ptrdiff_t>(row * sensing.features);
      ASSERT_TRUE(std::equal(first, first + static_cast<std::ptrdiff_t>(plain.features), other))
          << i;
    }
    ASSERT_EQ(plain.state, sensing.state);
    ASSERT_EQ(plain.action_masks, sensing.action_masks);
    ASSERT_EQ(plain.rewards, sensing.rewards);
  }
}

TEST(TrainingSenses, AgentsLookWhereTheyChoose) {
  SensingPool pool;
  for (const auto& [item, degrees] :
       {std::pair{"-90", -90.0}, std::pair{"0", 0.0}, std::pair{"60", 60.0}}) {
    pool.choose(0, "neck", item);
    pool.step_often(2);
    const double radians = degrees * std::numbers::pi / 180.0;
    EXPECT_NEAR(pool.seen(0, "own_neck_sin"), std::sin(radians), 0.02) << item;
    EXPECT_NEAR(pool.seen(0, "own_neck_cos"), std::cos(radians), 0.02) << item;
    EXPECT_NEAR(pool.view().players[10].neck, degrees, 1.0) << "left_11 is the first agent";
  }

  for (const char* item : {"wide", "narrow", "normal"}) {
    pool.choose(0, "view", item);
    pool.step_often(2);
    EXPECT_EQ(pool.seen(0, std::string("own_view_") + item), 1.0F);
  }
  EXPECT_EQ(pool.seen(0, "own_view_wide"), -1.0F);

  for (const auto& [item, meters] :
       {std::pair{"self", 0.0}, std::pair{"20", 20.0}, std::pair{"40", 40.0}}) {
    pool.choose(0, "focus", item);
    pool.step_often(2);
    EXPECT_NEAR(pool.seen(0, "own_focus_distance"), meters / 40.0, 0.03) << item;
  }
}

TEST(TrainingSenses, TeammatesHearSymbols) {
  SensingPool pool(R"(, "say": true, "agents": "both")");
  EXPECT_EQ(pool.seen(1, "heard_age"), 1.0F) << "none yet";
  pool.choose(0, "say", "C");
  pool.step_often(1);
  EXPECT_EQ(pool.seen(1, "heard_C"), 1.0F);
  EXPECT_EQ(pool.seen(1, "heard_B"), -1.0F);
  EXPECT_EQ(pool.seen(1, "heard_age"), 0.0F);
  EXPECT_EQ(pool.seen(1, "heard_number"), 1.0F) << "left_11";
  EXPECT_EQ(pool.seen(0, "heard_C"), -1.0F) << "its own";
  EXPECT_EQ(pool.seen(2, "heard_C"), -1.0F) << "an opponent";

  pool.choose(0, "say", "default");
  pool.step_often(3);
  EXPECT_EQ(pool.seen(1, "heard_C"), 1.0F) << "the last one stays";
  EXPECT_NEAR(pool.seen(1, "heard_age"), 0.1, 1e-6);
}

TEST(TrainingSenses, RefusesWhatCannotBe) {
  const auto error_of = [](const std::string& config) {
    std::uint64_t handle = 0;
    EXPECT_EQ(cls_training_create(config.c_str(), &handle), CLS_TRAINING_BAD_CONFIG);
    return std::string(cls_training_error());
  };
  EXPECT_EQ(error_of(R"({"task": "HalfFieldOffense", "look": true})"),
            "configuration: 'look' needs 'obs' = 'world_model': who knows the full state neither "
            "looks nor hears");
  EXPECT_EQ(error_of(R"({"task": "HalfFieldOffense", "say": true, "obs": "world_model", )"
                     R"("actions": "low_flat"})"),
            "configuration: 'say' needs actions with ids, which 'low_flat' has not; use "
            "'low_discrete' or 'skills'");

  SensingPool pool;
  pool.action_ids[pool.width + 2] = 4;
  EXPECT_EQ(pool.step(), CLS_TRAINING_BAD_ACTION);
  EXPECT_STREQ(cls_training_error(), "world 0, agent 1: view 4 is not in 0..3");
}

}  // namespace
}  // namespace cls::tests
