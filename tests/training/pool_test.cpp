// Pools: equal seeds and actions give equal bytes, whatever threads, neighbors and history are.
#include "training/pool/pool.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "tests/support/allocation_count.h"
#include "tests/training/stage.h"

namespace cls::tests {
namespace {

std::string play(BoundPool& pool, std::uint64_t seed, int steps) {
  soccer::RandomStream random(seed, "actions");
  // Written only where an episode ends, so that rows of an earlier play would remain.
  for (auto* array : {&pool.final_observations, &pool.final_state}) std::ranges::fill(*array, 0.0F);
  EXPECT_EQ(pool.reset(seed), CLS_TRAINING_OK) << cls_training_error();
  return pool.play(random, steps);
}

std::string config(const std::string& more) {
  return R"({"task": "HalfFieldOffense", "num_envs": 7, "autoreset": "same_step", "offense": 2,)"
         R"( "defense": 2, "actions": "low_all", "max_cycles": 60)" +
         more + "}";
}

TEST(TrainingPool, ResultsDoNotDependOnThreads) {
  BoundPool one(config(R"(, "threads": 1)"));
  BoundPool two(config(R"(, "threads": 2)"));
  BoundPool seven(config(R"(, "threads": 7)"));
  const std::string expected = play(one, 5, 150);
  EXPECT_TRUE(expected == play(two, 5, 150));
  EXPECT_TRUE(expected == play(seven, 5, 150));
}

TEST(TrainingPool, ResultsDoNotDependOnEarlierEpisodes) {
  BoundPool fresh(config(""));
  BoundPool used(config(""));
  play(used, 99, 80);
  EXPECT_TRUE(play(fresh, 5, 100) == play(used, 5, 100));
}

TEST(TrainingPool, StartsFromTheStateThatIsSeen) {
  BoundPool played(config(""), 5);
  soccer::RandomStream random(1, "actions");
  played.play(random, 20);
  cls_training_world world = played.view();
  world.ball_x = 20.0;

  BoundPool other(config(""), 50);
  ASSERT_EQ(cls_training_set_state(other.handle, 3, &world), CLS_TRAINING_OK)
      << cls_training_error();
  const cls_training_world seen = other.view(3);
  EXPECT_EQ(seen.ball_x, 20.0);
  EXPECT_EQ(seen.seed, world.seed);
  EXPECT_EQ(seen.cycle, world.cycle);
  EXPECT_EQ(seen.players[10].x, world.players[10].x);
  EXPECT_EQ(other.was_reset[3], 1);
  EXPECT_EQ(other.was_reset[2], 1) << "rows of other worlds stay";

  world.players[10].x = std::nan("");
  EXPECT_EQ(cls_training_set_state(other.handle, 3, &world), CLS_TRAINING_BAD_CONFIG);
  EXPECT_STREQ(cls_training_error(), "players[10].x: nan is not between -200 and 200");
  EXPECT_EQ(cls_training_set_state(other.handle, 7, &seen), CLS_TRAINING_BAD_INDEX);
  EXPECT_EQ(other.view(3).players[10].x, seen.players[10].x);
}

TEST(TrainingPool, OtherSeedsGiveOtherEpisodes) {
  BoundPool pool(config(""));
  EXPECT_FALSE(play(pool, 5, 20) == play(pool, 6, 20));
}

TEST(TrainingPool, EachWorldIsTheSameAlone) {
  BoundPool many(R"({"task": "HalfFieldOffense", "num_envs": 3, "defense": 1})");
  BoundPool one(R"({"task": "HalfFieldOffense", "num_envs": 1, "defense": 1})");
  ASSERT_EQ(many.reset(10), CLS_TRAINING_OK);
  ASSERT_EQ(one.reset(12), CLS_TRAINING_OK);

  soccer::RandomStream random(1, "actions");
  for (int i = 0; i < 50 && one.status[0] == CLS_TRAINING_IN_GAME; ++i) {
    many.draw_actions(random);
    one.action_ids[0] = many.action_ids[2];
    std::copy(many.action_values.end() - static_cast<std::ptrdiff_t>(many.value_columns.size()),
              many.action_values.end(), one.action_values.begin());
    ASSERT_EQ(many.step(), CLS_TRAINING_OK);
    ASSERT_EQ(one.step(), CLS_TRAINING_OK);
    const std::vector<float> last(
        many.observations.end() - static_cast<std::ptrdiff_t>(many.features),
        many.observations.end());
    EXPECT_EQ(last, one.observations);
  }
}

void expect_steps_do_not_allocate(BoundPool& pool) {
  soccer::RandomStream random(8, "actions");
  const std::int64_t before = allocation_count();
  for (int i = 0; i < 200; ++i) {
    pool.draw_actions(random);
    ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  }
  EXPECT_EQ(allocation_count() - before, 0);
}

TEST(TrainingPool, StepsDoNotAllocate) {
  BoundPool pool(config(""));
  play(pool, 3, 200);
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer replaces the allocator";
  expect_steps_do_not_allocate(pool);
}

TEST(TrainingPool, AMillionResetsDoNotAllocate) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "num_envs": 64})", 0);
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer replaces the allocator";
  const std::int64_t before = allocation_count();
  for (std::uint64_t first = 0; first < 1'000'000; first += 64) {
    std::iota(pool.seeds.begin(), pool.seeds.end(), first);
    ASSERT_EQ(cls_training_reset(pool.handle, nullptr, pool.seeds.data(), 64), CLS_TRAINING_OK);
  }
  EXPECT_EQ(allocation_count() - before, 0);
}

TEST(TrainingPool, WorldModelsDoNotAllocateAfterTheFirstCycles) {
  BoundPool pool(config(R"(, "obs": "world_model")"));
  play(pool, 3, 300);
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer replaces the allocator";
  expect_steps_do_not_allocate(pool);
}

TEST(TrainingPool, DrawsOpponentsFromAPool) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "defense": 2, "num_envs": 400,)"
                 R"( "opponent": {"hold": 1, "scripted": 3, "mock": 0}})",
                 1);
  std::array<int, 3> counts = {};
  for (const int drawn : pool.opponent) ++counts.at(static_cast<std::size_t>(drawn));
  EXPECT_NEAR(counts[0], 100, 40);
  EXPECT_NEAR(counts[1], 300, 40);
  EXPECT_EQ(counts[2], 0);
  const std::vector<std::int32_t> first = pool.opponent;
  ASSERT_EQ(pool.reset(1), CLS_TRAINING_OK);
  EXPECT_EQ(pool.opponent, first) << "a function of the seed";
}

TEST(TrainingPool, StandingOpponentsStandInTheirEpisodesOnly) {
  BoundPool pool(R"({"task": "HalfFieldOffense", "defense": 2, "num_envs": 40,)"
                 R"( "opponent": {"hold": 1, "scripted": 1}, "actions": "low_discrete"})",
                 1);
  const auto places = [&](std::size_t world) {
    const cls_training_world view = pool.view(world);
    return std::pair{view.players[12].x, view.players[12].y};
  };
  std::vector<std::pair<double, double>> before;
  for (std::size_t world = 0; world < 40; ++world) before.push_back(places(world));
  for (int i = 0; i < 10; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  for (std::size_t world = 0; world < 40; ++world) {
    EXPECT_EQ(places(world) == before[world], pool.opponent[world] == 0) << world;
  }
}

TEST(TrainingPool, WithoutOpponentsThereIsNone) {
  BoundPool alone(R"({"task": "HalfFieldOffense"})");
  BoundPool both(R"({"task": "HalfFieldDefense", "features": "ego", "agents": "both"})");
  ASSERT_EQ(alone.reset(1), CLS_TRAINING_OK);
  ASSERT_EQ(both.reset(1), CLS_TRAINING_OK);
  EXPECT_EQ(alone.opponent[0], -1);
  EXPECT_EQ(both.opponent[0], -1);
}

TEST(TrainingPool, NextStepResetsInTheStepAfterTheEnd) {
  BoundPool pool(R"({"task": "ReachBall", "autoreset": "next_step", "max_cycles": 5})", 1);
  EXPECT_EQ(pool.was_reset[0], 1);
  pool.next_seeds[0] = 77;
  for (int i = 0; i < 5; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_EQ(pool.truncated[0], 1);
  EXPECT_EQ(pool.terminated[0], 0);
  EXPECT_EQ(pool.status[0], CLS_TRAINING_OUT_OF_TIME);
  EXPECT_EQ(pool.cycles[0], 5);
  ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_EQ(pool.was_reset[0], 1);
  EXPECT_EQ(pool.truncated[0], 0);
  EXPECT_EQ(pool.cycles[0], 0);
  EXPECT_EQ(pool.seeds[0], 77U);
}

TEST(TrainingPool, SameStepKeepsTheFinalObservation) {
  BoundPool same(R"({"task": "ReachBall", "autoreset": "same_step", "max_cycles": 5})");
  BoundPool none(R"({"task": "ReachBall", "autoreset": "disabled", "max_cycles": 5})");
  ASSERT_EQ(same.reset(1), CLS_TRAINING_OK);
  ASSERT_EQ(none.reset(1), CLS_TRAINING_OK);

  same.next_seeds[0] = 2;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(same.step(), CLS_TRAINING_OK);
    ASSERT_EQ(none.step(), CLS_TRAINING_OK);
  }

  EXPECT_EQ(same.truncated[0], 1);
  EXPECT_EQ(same.was_reset[0], 1);
  EXPECT_EQ(same.final_observations, none.observations);
  EXPECT_EQ(same.final_state, none.state);
  ASSERT_EQ(none.reset(2), CLS_TRAINING_OK);
  EXPECT_EQ(same.observations, none.observations);
}

TEST(TrainingPool, DisabledAutoresetStandsStillAndThenRefuses) {
  BoundPool pool(R"({"task": "ReachBall", "num_envs": 2, "max_cycles": 5})", 1);
  for (int i = 0; i < 5; ++i) ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_EQ(pool.step(), CLS_TRAINING_BAD_ORDER);
  const std::uint8_t mask[] = {0, 1};
  const std::uint64_t seeds[] = {8, 9};
  ASSERT_EQ(cls_training_reset(pool.handle, mask, seeds, 2), CLS_TRAINING_OK);
  ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_EQ(pool.truncated[0], 1);
  EXPECT_EQ(pool.cycles[0], 5);
  EXPECT_EQ(pool.cycles[1], 1);
}

}  // namespace
}  // namespace cls::tests
