// End-to-end tests of `cls check perception`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

CommandResult check(const std::string& transcript, const std::string& truth, bool as_json = false) {
  std::vector<std::string> arguments = {cls_binary(), "check",   "perception",
                                        transcript,   "--truth", truth};
  if (as_json) arguments.push_back("--json");
  return run(arguments);
}

std::string transcript_fixture() { return fixture("perception/player_7.txt.gz").string(); }
std::string log_fixture() { return fixture("perception/game.rcg.gz").string(); }

TEST(CheckPerception, PrintsDocumentOfItsSchema) {
  const CommandResult result = check(transcript_fixture(), log_fixture(), true);
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.perception/1");
  EXPECT_EQ(document["player"], 7);
  EXPECT_EQ(document["team"], "PROXY");
  EXPECT_EQ(document["cycles"], 97);
  EXPECT_LT(document["self"]["mean"], 0.015);
  EXPECT_LT(document["body_angle"]["p95"], 1.5);
  EXPECT_GE(document["ball"]["n"], 66);
  for (const char* what : {"ball_velocity", "teammates", "opponents"}) {
    EXPECT_GT(document[what]["mean"], 0.0) << what;
    EXPECT_GE(document[what]["p95"], document[what]["mean"]) << what;
    EXPECT_GT(document[what]["n"], 0) << what;
  }
}

// PerceptionReplay in tests/proxy tests the figures themselves.
TEST(CheckPerception, PassesOnWholeLogs) {
  const auto log = data("aligned/game.rcg.gz");
  if (!log) GTEST_SKIP() << "no data: set CLS_DATA";
  for (const char* name : {"player_l1_goalie", "player_l4", "player_l7", "player_l10"}) {
    const CommandResult result = check(*data(std::string("aligned/udp/") + name + ".txt.gz"), *log);
    EXPECT_EQ(result.exit_code, 0) << name << ": " << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("of PROXY (left), "));
  }
}

TEST(CheckPerception, RejectsLogOfAnotherMatch) {
  const auto log = data("aligned/game.rcg.gz");
  const auto same_name = data("udp/synch/player_r11.txt.gz");
  const auto coach = data("aligned/udp/coach_l.txt.gz");
  const auto other_name = data("udp/synch/player_l9.txt.gz");
  if (!log || !same_name || !coach || !other_name) GTEST_SKIP() << "no data: set CLS_DATA";
  const auto expect_refusal = [&](const std::string& transcript, const char* why) {
    const CommandResult result = check(transcript, *log);
    EXPECT_EQ(result.exit_code, 65);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(why));
  };
  expect_refusal(*same_name, "the player types differ from those of the log");
  expect_refusal(*other_name, "the player is of team 'HELIOS_L' on the left, the log has 'PROXY'");
  expect_refusal(*coach, "no player connects");
}

TEST(CheckPerception, WritesAPageWithTheDecisions) {
  const TemporaryFolder folder;
  const auto page = folder.path() / "page.html";
  const auto written = [&](const std::filesystem::path& where) {
    return run({cls_binary(), "check", "perception", transcript_fixture(), "--truth", log_fixture(),
                "--page", where.string()});
  };
  EXPECT_EQ(written(page).exit_code, 65);  // the log of the fixture has no end
  const std::string text = read_file(page);
  EXPECT_THAT(text, HasSubstr("id=\"decisions-left\""));
  EXPECT_THAT(text, HasSubstr("\"players\":[\"l7\"]"));
  EXPECT_THAT(written(folder.path() / "no/page.html"), Exits(73, HasSubstr("no/page.html")));
}

TEST(CheckPerception, UsesLinesBeforeParseError) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "cut.txt";
  const std::string whole = read_file(transcript_fixture());
  std::ofstream(path) << whole.substr(0, whole.size() * 5 / 6) << "\nnonsense\n";
  const CommandResult result = check(path, log_fixture(), true);
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_THAT(result.err, HasSubstr(": not a transcript line"));
  const int cycles = json::parse(result.out)["cycles"].get<int>();
  EXPECT_GT(cycles, 0);
  EXPECT_LT(cycles, 97);
}

TEST(CheckPerception, ReadsTruncatedGzipFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "cut.txt.gz";
  std::ifstream packed(transcript_fixture(), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(packed)), std::istreambuf_iterator<char>());
  std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() * 5 / 6);
  const CommandResult result = check(path, log_fixture(), true);
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_THAT(result.err, HasSubstr("gzip data is truncated"));
  EXPECT_EQ(json::parse(result.out)["player"], 7);
}

TEST(CheckPerception, ReportsUnusableInput) {
  const TemporaryFolder folder;
  EXPECT_EQ(check("nowhere.txt", log_fixture()).exit_code, 66);
  EXPECT_EQ(check(transcript_fixture(), "nowhere.rcg").exit_code, 66);
  const std::string path = folder.path() / "empty.txt";
  std::ofstream(path) << "# nothing\n";
  const CommandResult unreachable = check(path, log_fixture());
  EXPECT_EQ(unreachable.exit_code, 65);
  EXPECT_THAT(unreachable.err, HasSubstr("no player connects"));
  EXPECT_EQ(unreachable.out, "");
  EXPECT_EQ(check(transcript_fixture(), path).exit_code, 65);
  EXPECT_THAT(run({cls_binary(), "check", "perception", path}),
              Exits(2, HasSubstr("cls check perception --help")));
  EXPECT_THAT(run({cls_binary(), "check", "perceptoin"}),
              Exits(2, HasSubstr("did you mean 'perception'?")));
}

}  // namespace
}  // namespace cls::tests
