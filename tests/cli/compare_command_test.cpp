// `cls compare` in a working folder of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

class Compare : public testing::Test {
 protected:
  Arguments argv(const Arguments& more) const {
    const Arguments arguments =
        joined({cls_binary(), "compare", "mock", "mock:hold", "--cycles", "10"}, more);
    return arguments;
  }
  CommandResult compare(Arguments more) const {
    return Command(argv(std::move(more)), {}, folder_.path()).finish();
  }
  std::size_t folders() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path() / "runs"), fs::directory_iterator()));
  }

  TemporaryFolder folder_;
};

TEST_F(Compare, ResumesBySameCommand) {
  const CommandResult first = compare({"--max-pairs", "1", "--json"});
  EXPECT_EQ(first.exit_code, 3) << first.err;
  EXPECT_EQ(json::parse(first.out)["matches"].size(), 2u);
  EXPECT_THAT(first.err, HasSubstr("/: pairs to play: 1\n"));
  EXPECT_THAT(first.err, HasSubstr("a larger --max-pairs continues\n"));
  const CommandResult second = compare({"--max-pairs", "3", "--json"});
  EXPECT_EQ(second.exit_code, 3) << second.err;
  const json document = json::parse(second.out);
  ASSERT_EQ(document["matches"].size(), 6u);
  EXPECT_EQ(document["matches"][0], json::parse(first.out)["matches"][0]) << "not played twice";
  EXPECT_EQ(folders(), 1u);
  EXPECT_EQ(compare({"--max-pairs", "1", "--seed", "2"}).exit_code, 3);
  EXPECT_EQ(folders(), 2u) << "another plan";
}

TEST_F(Compare, RespectsMaxPairsOfThisCommand) {
  ASSERT_EQ(compare({"--max-pairs", "2", "--dir", "c"}).exit_code, 3);
  const CommandResult fewer = compare({"--max-pairs", "1", "--dir", "c", "--json"});
  EXPECT_EQ(fewer.exit_code, 3) << fewer.err;
  EXPECT_EQ(json::parse(fewer.out)["matches"].size(), 2u);
  EXPECT_EQ(json::parse(fewer.out)["samples"], json({0, 0, 1, 0, 0}));
  const CommandResult forced = compare({"--max-pairs", "1", "--dir", "c", "--force", "--json"});
  EXPECT_EQ(forced.exit_code, 3) << forced.err;
  EXPECT_TRUE(fs::exists(folder_.path() / "c.old" / "tournament.db"));
  EXPECT_EQ(json::parse(forced.out)["matches"].size(), 2u);
}

// A change without effect would be undecided for hours.
TEST_F(Compare, TellsAfterTheFirstPairThatBothSidesPlayTheSame) {
  const Arguments same = {cls_binary(), "compare", "mock", "mock", "--cycles", "30"};
  const auto compare_same = [&](const Arguments& more) {
    return Command(joined(same, more), {}, folder_.path()).finish();
  };

  const CommandResult direct = compare_same({"--max-pairs", "2", "--concurrency", "1"});

  EXPECT_EQ(direct.exit_code, 3) << direct.err;
  EXPECT_THAT(direct.err, HasSubstr("warning: mock and mock_base are the same side: "));
  const std::size_t note =
      direct.err.find("mock and mock_base sent the same commands in all cycles");
  ASSERT_NE(note, std::string::npos) << direct.err;
  EXPECT_LT(note, direct.err.find("match 3/4")) << direct.err;
  EXPECT_THAT(direct.out, HasSubstr("in 2 of 2 pairs mock and mock_base sent the same commands"));

  const CommandResult quartets =
      compare_same({"--opponents", "mock:hold", "--max-pairs", "1", "--json"});
  EXPECT_EQ(json::parse(quartets.out)["alike"], 1) << quartets.err;
  EXPECT_EQ(json::parse(compare({"--max-pairs", "1", "--json"}).out)["alike"], 0);
}

TEST_F(Compare, ForceRenamesNothingBeforeTeamsAreChecked) {
  ASSERT_EQ(compare({"--max-pairs", "1", "--dir", "c"}).exit_code, 3);
  EXPECT_THAT(
      compare({"--max-pairs", "1", "--dir", "c", "--force", "--server", "cls_no_such_server"}),
      Exits(66));
  EXPECT_TRUE(fs::exists(folder_.path() / "c" / "tournament.db"));
  EXPECT_FALSE(fs::exists(folder_.path() / "c.old"));
}

TEST_F(Compare, PrintsStateOfTestAndResumeCommand) {
  Command playing(argv({"--elo1", "5", "--concurrency", "1"}), {}, folder_.path());
  const auto results = [&] {
    return fs::exists(folder_.path() / "runs")
               ? run({"/bin/sh", "-c",
                      "ls " + folder_.path().string() + "/runs/*/matches/*/result.json"})
                     .out
               : std::string();
  };
  while (std::ranges::count(results(), '\n') < 3) std::this_thread::sleep_for(50ms);
  playing.send_signal(SIGINT);

  const CommandResult ended = playing.finish(10s);

  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("pairs to play: 7 if NEW wins all, about "));
  EXPECT_THAT(ended.err, HasSubstr("pairs 1  +0 Elo ("));
  EXPECT_THAT(ended.err, HasSubstr("  evidence 1.0/20 for, 1.0/20 against  "));
  EXPECT_THAT(ended.err, HasSubstr(" left\n"));
  EXPECT_THAT(ended.err,
              HasSubstr("cls: resume: " + cls_binary().string() +
                        " compare mock mock:hold --cycles 10 --elo1 5 --concurrency 1\n"));
}

}  // namespace
}  // namespace cls::tests
