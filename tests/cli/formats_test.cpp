// Files of former versions are read, those of later ones refused with one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// A folder with a copy of fixtures/formats.
class Formats : public testing::Test {
 protected:
  Formats() { fs::copy(fixture("formats"), folder_.path(), fs::copy_options::recursive); }

  CommandResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), cls_binary());
    return Command(words, {}, folder_.path()).finish();
  }

  void replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = read_file(folder_.path() / name);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name;
    text.replace(at, from.size(), to);
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }

  void expect_refusal(const std::vector<std::string>& words, int exit_code,
                      const std::string& text) const {
    const CommandResult result = run(words);
    EXPECT_EQ(result.exit_code, exit_code) << words[0];
    EXPECT_THAT(result.err, HasSubstr(text));
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Formats, OfTheFirstReleaseAreRead) {
  EXPECT_THAT(run({"test", "scenario.json"}), Exits(0));
  const CommandResult replay = run({"test", "--replay", "match.rpc", "mock:hold"});
  EXPECT_THAT(replay.out, HasSubstr("25 replies as recorded")) << replay.err;
  EXPECT_THAT(run({"tournament", "plan", "."}), Exits(0));

  const CommandResult report = run({"tournament", "report", "."});
  EXPECT_THAT(report.out, HasSubstr("BLUE    0:0  RED")) << report.err;
  EXPECT_THAT(run({"watch", "page.html", "--out", "again.html"}), Exits(0));

  fs::create_directory(folder_.path() / "match");
  fs::rename(folder_.path() / "result.json", folder_.path() / "match/result.json");
  const CommandResult logs = run({"logs", "match"});
  EXPECT_THAT(logs.out, HasSubstr("finished")) << logs.err;
  const CommandResult search = run({"tune", "report", "search"});
  EXPECT_THAT(search.out, HasSubstr("generation 1 of 1, 4 pairs")) << search.err;
  EXPECT_THAT(run({"match", "planner:planner.toml=mock:hold", "mock:hold", "--cycles", "3", "--dir",
                   "planned", "--quiet"}),
              Exits(0));
}

// A saved match is simulated again up to its cycle. A cls whose players act differently reads it,
// finds the difference and says so.
TEST_F(Formats, SavedMatchOfTheFirstReleaseGoesOnOrDiffers) {
  const CommandResult resumed = run({"match", "mock:hold", "mock", "--cycles", "12", "--resume",
                                     "saved.match", "--dir", "resumed", "--quiet"});
  const bool goes_on = resumed.out.find("12 cycles") != std::string::npos;
  EXPECT_EQ(resumed.exit_code == 0, goes_on) << resumed.out << resumed.err;
  if (goes_on) return;
  EXPECT_THAT(resumed.err,
              HasSubstr("differs from the saved one at cycle 6; it was saved by cls 0.1.0"));
}

TEST_F(Formats, OfLaterReleasesAreRefusedInOneLine) {
  replace("scenario.json", "cls.scenario/1", "cls.scenario/2");
  expect_refusal({"test", "scenario.json"}, 65,
                 "schema cls.scenario/2 is newer than this cls reads (cls.scenario/1); update cls");
  replace("cls.toml", "schema = 1", "schema = 2");
  expect_refusal({"tournament", "plan", "."}, 78,
                 "cls.toml:1: schema 2 is newer than this cls reads (1); update cls");
  replace("plan.toml", "[tournament]", "schema = 2\n[tournament]");
  expect_refusal({"tournament", "report", "."}, 65,
                 "plan.toml:1: schema 2 is newer than this cls reads (1); update cls");

  replace("search/tune.toml", "schema = 1", "schema = 2");

  expect_refusal({"tune", "report", "search"}, 78,
                 "tune.toml:4: schema 2 is newer than this cls reads (1); update cls");
  replace("planner.toml", "schema = 1", "schema = 2");
  expect_refusal({"match", "planner:planner.toml=mock", "mock"}, 65,
                 "planner.toml:5: schema 2 is newer than this cls reads (1); update cls");
  replace("result.json", "cls.match/1", "cls.match/2");
  fs::create_directory(folder_.path() / "match");
  fs::rename(folder_.path() / "result.json", folder_.path() / "match/result.json");
  expect_refusal({"logs", "match"}, 65,
                 "result.json: schema cls.match/2 is newer than this cls reads (cls.match/1); "
                 "update cls");
}

TEST_F(Formats, WithoutASchemaAreOfTheFirstVersion) {
  replace("scenario.json", "  \"schema\": \"cls.scenario/1\",\n", "");
  EXPECT_EQ(run({"test", "scenario.json"}).exit_code, 0);
  replace("cls.toml", "schema = 1\n", "");
  EXPECT_EQ(run({"tournament", "plan", "."}).exit_code, 0);
  replace("cls.toml", "[tournament]", "schema = \"x\"\n[tournament]");
  expect_refusal({"tournament", "plan", "."}, 78, "schema: must be a whole number from 1 to 1");
}

}  // namespace
}  // namespace cls::tests
