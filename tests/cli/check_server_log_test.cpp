// End-to-end tests of `cls check server-log`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

std::string game_fixture() { return fixture("simulator/noise-free.rcg.gz").string(); }
std::string text_fixture() { return fixture("simulator/noise-free.rcl.gz").string(); }

CommandResult check(const std::string& game, const std::string& text, bool as_json = false) {
  std::vector<std::string> arguments = {cls_binary(), "check", "server-log", game, text};
  if (as_json) arguments.push_back("--json");
  return run(arguments);
}

TEST(CheckServerLog, PrintsDocumentOfItsSchema) {
  // An excerpt is a truncated log (exit code), but the check passes.
  const CommandResult result = check(game_fixture(), text_fixture(), true);
  const json document = json::parse(result.out);

  EXPECT_EQ(document["schema"], "cls.server-log/1");
  EXPECT_EQ(document["passed"], true);
  EXPECT_EQ(document["agreement"], 1.0);
  EXPECT_EQ(document["steps"], 23 * 424);
  EXPECT_EQ(document["agreed"], 23 * 424);
  EXPECT_EQ(document["ball"]["steps"], 424);
  EXPECT_EQ(document["players"]["agreed"], 22 * 424);
  EXPECT_LT(document["excused_share"], 0.005);
  EXPECT_GT(document["by_class"]["player_dash"]["steps"], 1000);
  EXPECT_LT(document["by_class"]["player_dash"]["worst"], 2.1e-4);
  EXPECT_GE(document["by_cause"].value("tackle", 0), 0);

  for (const char* what : {"mode", "clock", "score", "counters", "state"}) {
    EXPECT_EQ(document[what]["steps"], document[what]["agreed"]) << what;
  }
  EXPECT_TRUE(document["misses"].empty());
}

TEST(CheckServerLog, ReadsAllGameLogVersions) {
  const TemporaryFolder folder;
  for (const char* version : {"4", "5", "json"}) {
    const std::string path = folder.path() / (std::string("game.") + version);
    run({cls_binary(), "convert", game_fixture(), path, "--to", version});
    const json document = json::parse(check(path, text_fixture(), true).out);
    EXPECT_EQ(document["steps"], 23 * 424) << version;
    EXPECT_EQ(document["passed"], true) << version << document["demands"];
  }
}

TEST(CheckServerLog, FailsAndReportsDifferentSteps) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "game.rcl";
  std::string text = read_file(text_fixture());
  // Replace the dash commands of the left team by turns.
  const std::string dash = "(dash ";
  for (std::size_t at = text.find(dash); at != std::string::npos; at = text.find(dash, at + 1)) {
    if (text.rfind("HELIOS_L_5:", at) > text.rfind('\n', at)) text.replace(at + 1, 4, "turn");
  }
  std::ofstream(path) << text;
  EXPECT_THAT(check(game_fixture(), path),
              Prints(1, testing::AllOf(HasSubstr(" l5 player_turn: position "),
                                       HasSubstr("FAIL counters"))));
}

TEST(CheckServerLog, ReportsFailuresByExitCode) {
  const TemporaryFolder folder;
  EXPECT_EQ(check("nowhere.rcg", text_fixture()).exit_code, 66);
  EXPECT_EQ(check(game_fixture(), "nowhere.rcl").exit_code, 66);
  const std::string empty = folder.path() / "empty";
  std::ofstream(empty) << "";
  EXPECT_EQ(check(empty, text_fixture()).exit_code, 65);
  EXPECT_EQ(check(game_fixture(), empty).exit_code, 65);
  EXPECT_EQ(check(fixture("gamelog/rcg-v1-excerpt.rcg.gz").string(), text_fixture()).exit_code, 65);

  const std::string cut = folder.path() / "cut.rcg";
  std::ofstream(cut) << read_file(game_fixture()).substr(0, 600000);
  const CommandResult damaged = check(cut, text_fixture(), true);
  EXPECT_EQ(damaged.exit_code, 65);
  EXPECT_THAT(damaged.err, HasSubstr("truncated log"));
  EXPECT_EQ(json::parse(damaged.out)["passed"], true);

  const std::string cut_text = folder.path() / "cut.rcl";
  const std::string text = read_file(text_fixture());
  std::ofstream(cut_text) << text.substr(0, text.size() * 2 / 3);
  const CommandResult half = check(game_fixture(), cut_text, true);
  EXPECT_EQ(half.exit_code, 65) << half.err;

  const json document = json::parse(half.out);
  EXPECT_EQ(document["passed"], true) << document["demands"];
  EXPECT_GT(document["skipped"], 50);
  EXPECT_EQ(run({cls_binary(), "check", "server-log", empty}).exit_code, 2);
}

}  // namespace
}  // namespace cls::tests
