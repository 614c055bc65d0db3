// Episodes: copies, recordings, heterogeneous types.
#include "training/episode/episode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"
#include "tests/support/temporary_folder.h"
#include "tests/training/stage.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

constexpr const char* kConfig =
    R"({"task": "HalfFieldOffense", "num_envs": 2, "offense": 2, "defense": 2, "actions": "hfo"})";

std::string play(BoundPool& pool, int steps) {
  soccer::RandomStream random(21, "actions");
  return pool.play(random, steps);
}

TEST(TrainingEpisode, RestoredSnapshotGivesTheSameSteps) {
  BoundPool pool(kConfig, 1);
  play(pool, 10);
  std::uint64_t first = 0;
  std::uint64_t second = 0;
  ASSERT_EQ(cls_training_snapshot(pool.handle, 0, &first), CLS_TRAINING_OK);
  ASSERT_EQ(cls_training_snapshot(pool.handle, 1, &second), CLS_TRAINING_OK);
  const std::string expected = play(pool, 20);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(cls_training_restore(pool.handle, 0, first), CLS_TRAINING_OK);
    ASSERT_EQ(cls_training_restore(pool.handle, 1, second), CLS_TRAINING_OK);
    EXPECT_EQ(play(pool, 20), expected);
  }

  EXPECT_EQ(cls_training_release(pool.handle, first), CLS_TRAINING_OK);
  EXPECT_EQ(cls_training_restore(pool.handle, 0, first), CLS_TRAINING_BAD_HANDLE);
}

TEST(TrainingEpisode, ForksDivergeWithTheirActionsOnly) {
  BoundPool pool(kConfig, 1);
  play(pool, 5);
  ASSERT_EQ(cls_training_fork(pool.handle, 0, 1), CLS_TRAINING_OK);
  std::fill(pool.action_ids.begin(), pool.action_ids.end(), 18);
  ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  const auto half = pool.state.begin() + static_cast<std::ptrdiff_t>(pool.states);
  EXPECT_TRUE(std::equal(pool.state.begin(), half, half));
  pool.action_ids[0] = 19;
  ASSERT_EQ(pool.step(), CLS_TRAINING_OK);
  EXPECT_FALSE(std::equal(pool.state.begin(), half, half));
}

TEST(TrainingEpisode, RecordingIsAGameLog) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "episode.rcg").string();
  BoundPool pool(kConfig);
  ASSERT_EQ(cls_training_record(pool.handle, 0, path.c_str()), CLS_TRAINING_OK);
  ASSERT_EQ(pool.reset(7), CLS_TRAINING_OK);

  play(pool, 12);
  ASSERT_EQ(pool.reset(8), CLS_TRAINING_OK) << cls_training_error();
  const std::string text = read_file(path);
  EXPECT_EQ(text.substr(0, 5), "ULG6\n");
  EXPECT_THAT(text, HasSubstr(" play_on)"));

  const auto lines = split_lines(text);
  EXPECT_EQ(std::ranges::count_if(lines, [](auto line) { return line.starts_with("(show "); }), 13)
      << "the start and twelve steps";
  const std::string commands = read_file((folder.path() / "episode.rcl").string());
  EXPECT_EQ(commands.substr(0, 9), "0,0\tRecv ");
  EXPECT_THAT(commands, HasSubstr("left_7: ("));
}

TEST(TrainingEpisode, RecordingThatCannotBeWrittenIsAnError) {
  BoundPool pool(kConfig);
  EXPECT_EQ(cls_training_record(pool.handle, 0, "/nowhere/episode.rcg"), CLS_TRAINING_BAD_FILE);
  EXPECT_THAT(std::string(cls_training_error()), HasSubstr("/nowhere/episode.rcg"));
}

TEST(TrainingEpisode, GoalieIsAnAgentIfAskedForOrIfAllAre) {
  const auto agents = [](const std::string& more) {
    std::vector<std::string> names;
    const auto setup = setup_of(R"({"task": "HalfFieldDefense", "defense": 3)" + more + "}");
    for (const int slot : setup->cast.agents) names.push_back(training::agent_name(slot));
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(agents(R"(, "num_agents": 1)"), (Names{"right_2"}));
  EXPECT_EQ(agents(R"(, "num_agents": 2)"), (Names{"right_2", "right_3"}));
  EXPECT_EQ(agents(R"(, "num_agents": 1, "goalie_agent": true)"), (Names{"right_1"}));
  EXPECT_EQ(agents(""), (Names{"right_1", "right_2", "right_3"}));
}

TEST(TrainingEpisode, RandomTypesComeFromTheSeed) {
  const auto setup =
      setup_of(R"({"task": "HalfFieldOffense", "offense": 4, "defense": 4, "types": "random"})");
  training::Episode episode(setup);
  std::set<int> types;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    episode.reset(seed, setup->options);
    for (const int slot : setup->cast.left) types.insert(episode.world().player(slot).type);
    EXPECT_EQ(episode.world().player(setup->cast.right[0]).type, 0);
  }
  EXPECT_GT(types.size(), 5U);
}

}  // namespace
}  // namespace cls::tests
