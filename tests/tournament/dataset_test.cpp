// Data sets: what is written and read again.
#include "tournament/dataset/dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/dataset/data_card.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;

DatasetMatch match_17() {
  DatasetMatch match;
  match.fixture.index = 17;
  match.left = "A";
  match.right = "B";
  match.score = {2, 1};
  match.end_reason = "finished";
  match.files = {{"shards/000/000017.view.gz", 12, "abc"}};
  return match;
}

TEST(Dataset, ReadsTheLinesThatItWrites) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(write_dataset(config_of(Format::kRoundRobin, 2), {match_17()}, folder.path()));
  const auto matches = read_dataset_matches(folder.path());
  ASSERT_TRUE(matches) << matches.error().message;
  ASSERT_EQ(matches->size(), 1u);
  EXPECT_EQ(format_dataset_match(matches->front()), format_dataset_match(match_17()));
  EXPECT_EQ(matches->front().score, std::pair(2, 1));
}

TEST(Dataset, TellsWhatEqualSidesHaveTwice) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.competition.teams[0].endpoint = "mock";
  config.competition.teams[1].endpoint = "mock:hold";
  EXPECT_EQ(twin_sides(config), "");
  config.competition.teams[1].endpoint = "mock";
  EXPECT_THAT(twin_sides(config), testing::HasSubstr(" are the same side: "));
  EXPECT_THAT(data_card(config, {match_17()}), testing::HasSubstr("| mirror images | "));
  config.competition.swap_sides = false;
  EXPECT_EQ(twin_sides(config), "");
}

TEST(Dataset, RemovesFilesOfNoMatchAndOutlivesLinksToNothing) {
  const tests::TemporaryFolder folder;
  const fs::path shard = folder.path() / kDatasetShards / "000";
  fs::create_directories(shard);
  std::ofstream(shard / "000099.view.gz") << "x";
  fs::create_symlink("loop", shard / "loop");

  ASSERT_TRUE(write_dataset(config_of(Format::kRoundRobin, 2), {match_17()}, folder.path()));
  EXPECT_FALSE(fs::exists(shard / "000099.view.gz"));
  EXPECT_TRUE(fs::is_symlink(shard / "loop"));
}

}  // namespace
}  // namespace cls::tournament
