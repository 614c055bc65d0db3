// Files of former versions are read, those of later ones refused with one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

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
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Formats, OfTheFirstReleaseAreRead) {
  const CommandResult scenario = run({"test", "scenario.json"});
  EXPECT_EQ(scenario.exit_code, 0) << scenario.out << scenario.err;
  const CommandResult replay = run({"test", "--replay", "match.rpc", "mock:hold"});
  EXPECT_NE(replay.out.find("25 replies as recorded"), std::string::npos) << replay.err;
  const CommandResult plan = run({"tournament", "plan", "."});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  const CommandResult report = run({"tournament", "report", "."});
  EXPECT_NE(report.out.find("BLUE    0:0  RED"), std::string::npos) << report.out << report.err;
  const CommandResult page = run({"watch", "page.html", "--out", "again.html"});
  EXPECT_EQ(page.exit_code, 0) << page.err;
  fs::create_directory(folder_.path() / "match");
  fs::rename(folder_.path() / "result.json", folder_.path() / "match/result.json");
  const CommandResult logs = run({"logs", "match"});
  EXPECT_NE(logs.out.find("finished"), std::string::npos) << logs.out << logs.err;
}

TEST_F(Formats, OfLaterReleasesAreRefusedInOneLine) {
  replace("scenario.json", "cls.scenario/1", "cls.scenario/2");
  expect_refusal({"test", "scenario.json"}, 65,
                 "schema cls.scenario/2 is newer than this cls reads (cls.scenario/1); update cls");
  replace("cls.toml", "schema = 1", "schema = 2");
  expect_refusal({"tournament", "plan", "."}, 78,
                 "cls.toml:1: schema 2 is newer than this cls reads (1); update cls");
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
