// The C interface answers bad input with a code and a text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/support/files.h"
#include "tests/training/stage.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

constexpr const char* kConfig =
    R"({"task": "HalfFieldOffense", "num_envs": 2, "actions": "low", "autoreset": "next_step"})";

void expect_error(int code, int expected, std::string_view part) {
  EXPECT_EQ(code, expected);
  const std::string_view text = cls_training_error();
  EXPECT_THAT(text, HasSubstr(part));
  EXPECT_EQ(text.find('\n'), std::string_view::npos);
}

int create(const char* config) {
  std::uint64_t pool = 0;
  const int code = cls_training_create(config, &pool);
  if (code == CLS_TRAINING_OK) cls_training_close(pool);
  return code;
}

TEST(TrainingCApi, RefusesBadConfigurations) {
  constexpr int kBad = CLS_TRAINING_BAD_CONFIG;
  expect_error(create("{"), kBad, "configuration");
  expect_error(create("[]"), kBad, "object");
  expect_error(create("{}"), kBad, "task");
  expect_error(create(R"({"task": "HalfFieldOffence"})"), kBad, "did you mean 'HalfFieldOffense'");
  expect_error(create(R"({"task": "ReachBall", "num_env": 2})"), kBad, "num_envs");
  expect_error(create(R"({"task": "ReachBall", "num_envs": 0})"), kBad, "num_envs");
  expect_error(create(R"({"task": "ReachBall", "num_envs": 1e9})"), kBad, "num_envs");
  expect_error(create(R"({"task": "ReachBall", "obs": "all"})"), kBad, "full_state");
  expect_error(create(R"({"task": "ReachBall", "defense": 3})"), kBad, "defense");
  expect_error(create(R"({"task": "ReachBall", "num_agents": 3})"), kBad, "num_agents");
  expect_error(create(R"({"task": "ReachBall", "features": "hfo_lo"})"), kBad, "hfo_low");
  expect_error(create(R"({"task": "ReachBall", "reward": {"goals": 1}})"), kBad, "goal");
  expect_error(create(R"({"task": "ReachBall", "opponent": "helios"})"), kBad, "planner");
  expect_error(create(R"({"task": "ReachBall", "opponent": {"mocc": 1}})"), kBad, "mock");
  expect_error(create(R"({"task": "ReachBall", "opponent": {"mock": -1}})"), kBad, "mock");
  expect_error(create(R"({"task": "ReachBall", "opponent": {"mock": 0}})"), kBad, "above 0");
  expect_error(create(R"({"task": "ReachBall", "teammates": "none"})"), kBad, "scripted");
  expect_error(create(R"({"task": "ReachBall", "options": {"speed": 9}})"), kBad, "speed");
}

TEST(TrainingCApi, RefusesNullPointers) {
  constexpr int kBad = CLS_TRAINING_BAD_POINTER;
  BoundPool pool(kConfig);
  std::uint64_t handle = 0;
  std::size_t length = 0;
  expect_error(cls_training_create(nullptr, &handle), kBad, "config_json");
  expect_error(cls_training_create(kConfig, nullptr), kBad, "pool");
  expect_error(cls_training_catalog(nullptr, 5, &length), kBad, "out");
  expect_error(cls_training_spec(pool.handle, nullptr, 0, nullptr), kBad, "length");
  expect_error(cls_training_bind(pool.handle, nullptr), kBad, "buffers");
  expect_error(cls_training_reset(pool.handle, nullptr, nullptr, 2), kBad, "seeds");
  expect_error(cls_training_set_options(pool.handle, 0, nullptr), kBad, "options_json");
  expect_error(cls_training_snapshot(pool.handle, 0, nullptr), kBad, "snapshot");
  expect_error(cls_training_view(pool.handle, 0, nullptr), kBad, "world");
}

TEST(TrainingCApi, ChecksBuffers) {
  BoundPool pool(kConfig);
  cls_training_buffers buffers = pool.buffers;
  buffers.struct_size = 8;
  expect_error(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_BAD_SIZE, "struct_size");

  buffers = pool.buffers;
  buffers.observations.count -= 1;
  expect_error(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_BAD_SIZE, "observations");

  buffers = pool.buffers;
  buffers.rewards.data = nullptr;
  expect_error(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_BAD_POINTER, "rewards");

  buffers = pool.buffers;
  buffers.next_seeds.data = nullptr;
  expect_error(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_BAD_POINTER, "next_seeds");
  buffers = pool.buffers;
  buffers.state.data = static_cast<char*>(buffers.state.data) + 1;
  expect_error(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_BAD_POINTER, "aligned");
  buffers = pool.buffers;
  buffers.state.data = nullptr;
  EXPECT_EQ(cls_training_bind(pool.handle, &buffers), CLS_TRAINING_OK);
}

TEST(TrainingCApi, PythonHasTheSameArrays) {
  const std::string module = read_file(source_folder() / "python" / "cls_gym" / "_engine.py");
  std::size_t last = module.find("_ARRAYS");
#define CLS_TRAINING_ARRAY(type, name, count, needed) \
  last = module.find("\"" #name "\": (np.", last);    \
  ASSERT_NE(last, std::string::npos) << #name;
#include "training/pool/arrays.inc"
}

TEST(TrainingCApi, ChecksOrderAndIndices) {
  std::uint64_t handle = 0;
  ASSERT_EQ(cls_training_create(kConfig, &handle), CLS_TRAINING_OK);

  const std::uint64_t seeds[] = {1, 2};
  expect_error(cls_training_step(handle), CLS_TRAINING_BAD_ORDER, "bind");
  expect_error(cls_training_reset(handle, nullptr, seeds, 2), CLS_TRAINING_BAD_ORDER, "bind");
  EXPECT_EQ(cls_training_close(handle), CLS_TRAINING_OK);

  BoundPool pool(kConfig);
  std::uint64_t snapshot = 0;
  expect_error(pool.step(), CLS_TRAINING_BAD_ORDER, "reset");
  expect_error(cls_training_snapshot(pool.handle, 0, &snapshot), CLS_TRAINING_BAD_ORDER, "reset");
  expect_error(cls_training_snapshot(pool.handle, 2, &snapshot), CLS_TRAINING_BAD_INDEX, "2");
  expect_error(cls_training_fork(pool.handle, 0, 9), CLS_TRAINING_BAD_INDEX, "9");
  expect_error(cls_training_restore(pool.handle, 0, 9), CLS_TRAINING_BAD_HANDLE, "9");
  expect_error(cls_training_set_options(pool.handle, 5, "{}"), CLS_TRAINING_BAD_INDEX, "5");
  expect_error(cls_training_set_options(pool.handle, -2, "{}"), CLS_TRAINING_BAD_INDEX, "-2");
  expect_error(cls_training_set_options(pool.handle, 0, R"({"dificulty": 1})"),
               CLS_TRAINING_BAD_CONFIG, "difficulty");
  expect_error(cls_training_reset(pool.handle, nullptr, seeds, 1), CLS_TRAINING_BAD_SIZE, "2");
}

TEST(TrainingCApi, RefusesBadActionsBeforeAnyWorldMoves) {
  BoundPool pool(kConfig, 1);
  const std::string before = pool.outputs();
  pool.action_ids[1] = 3;
  expect_error(pool.step(), CLS_TRAINING_BAD_ACTION, "world 1");

  pool.action_ids[1] = -1;
  expect_error(pool.step(), CLS_TRAINING_BAD_ACTION, "-1");
  pool.action_ids[1] = 0;
  pool.action_values.back() = std::numeric_limits<float>::quiet_NaN();
  expect_error(pool.step(), CLS_TRAINING_BAD_ACTION, "kick_direction");
  pool.action_values.back() = std::numeric_limits<float>::infinity();
  expect_error(pool.step(), CLS_TRAINING_BAD_ACTION, "finite");
  EXPECT_EQ(pool.outputs(), before);
  pool.action_values.back() = 1e30F;
  EXPECT_EQ(pool.step(), CLS_TRAINING_OK) << "finite values are clipped";
}

TEST(TrainingCApi, ClosedPoolsStayClosed) {
  std::uint64_t handle = 0;
  ASSERT_EQ(cls_training_create(kConfig, &handle), CLS_TRAINING_OK);
  EXPECT_EQ(cls_training_close(handle), CLS_TRAINING_OK);
  expect_error(cls_training_close(handle), CLS_TRAINING_BAD_HANDLE, "closed");
  expect_error(cls_training_step(handle), CLS_TRAINING_BAD_HANDLE, "closed");
  expect_error(cls_training_step(0), CLS_TRAINING_BAD_HANDLE, "0");
}

TEST(TrainingCApi, SmallTextBuffersSayHowMuchIsNeeded) {
  std::size_t length = 0;
  EXPECT_EQ(cls_training_catalog(nullptr, 0, &length), CLS_TRAINING_SMALL_BUFFER);
  std::string text(length + 1, '?');
  EXPECT_EQ(cls_training_catalog(text.data(), text.size(), &length), CLS_TRAINING_OK);
  EXPECT_EQ(text[0], '{');
  EXPECT_EQ(text[length], '\0');
  char few[5] = {'?', '?', '?', '?', '?'};
  EXPECT_EQ(cls_training_catalog(few, 4, &length), CLS_TRAINING_SMALL_BUFFER);
  EXPECT_EQ(few[3], '\0');
  EXPECT_EQ(few[4], '?');
}

TEST(TrainingCApi, RefusesASecondThreadInsteadOfHanging) {
  for (const char* threads : {"1", "2"}) {
    BoundPool pool(R"({"task": "HalfFieldOffense", "num_envs": 64, "actions": "low",)"
                   R"( "autoreset": "next_step", "threads": )" +
                       std::string(threads) + "}",
                   1);

    std::atomic<int> refused{0};
    std::atomic<int> others{0};
    std::vector<std::thread> callers;
    for (int i = 0; i < 4; ++i) {
      callers.emplace_back([&] {
        for (int step = 0; step < 200; ++step) {
          const int code = pool.step();
          if (code == CLS_TRAINING_OK) continue;
          const bool named = std::string_view(cls_training_error()).find("another thread") !=
                             std::string_view::npos;
          ++(code == CLS_TRAINING_BAD_ORDER && named ? refused : others);
        }
      });
    }

    for (std::thread& caller : callers) caller.join();
    EXPECT_GT(refused, 0) << threads;
    EXPECT_EQ(others, 0) << threads;
    EXPECT_EQ(pool.step(), CLS_TRAINING_OK) << "afterwards one thread may step again";
  }
}

TEST(TrainingCApi, PoolsOfTheParentAreRefusedAfterAFork) {
  BoundPool pool(kConfig, 1);
  const pid_t child = ::fork();
  if (child == 0) ::_exit(pool.step() == CLS_TRAINING_FORKED ? 0 : 1);
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace cls::tests
