// What a user learns of a Playmaker that fails, or whose actions have no effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

/// Matches of `mock:hold` (left) against a script (right).
class PlaymakerErrors : public testing::Test {
 protected:
  /// A side whose script has this content.
  std::string script(const std::string& name, const std::string& text) const {
    const std::string file = folder_.path() / (name + ".json");
    std::ofstream(file) << text;
    return "mock:" + file;
  }
  /// The replies of player 9 in cycle 5 fail.
  std::string failing(const std::string& status, const std::string& message) const {
    return script("failing", R"({"otherwise": "hold", "faults": {"error": 1, "status": ")" +
                                 status + R"(", "message": ")" + message +
                                 R"(", "only": {"cycle": [5, 5], "unum": 9}}})");
  }

  void play(const std::string& right, const Arguments& more = {}) {
    std::filesystem::remove_all(folder_.path() / "match");
    played_ = run(joined(
        {cls_binary(), "match", "mock:hold", right, "--right-name", "brain", "--cycles", "20",
         "--seed", "7", "--set", "server::kick_off_wait=3", "--dir", folder_.path() / "match"},
        more));
    result_ = json::parse(read_file(folder_.path() / "match/result.json"));
  }
  CommandResult replay(const std::string& file, const std::string& side) const {
    return run({cls_binary(), "test", "--replay", folder_.path() / file, side});
  }

  std::string warnings() const { return result_["warnings"].dump(); }
  void expect_printed(const std::string& text) const { EXPECT_THAT(played_.out, HasSubstr(text)); }
  void expect_warning(const std::string& text) const {
    EXPECT_THAT(warnings(), HasSubstr(text));
    EXPECT_THAT(played_.err, HasSubstr(text));
  }

  TemporaryFolder folder_;
  CommandResult played_;
  json result_;
};

TEST_F(PlaymakerErrors, NamesFirstErrorWithPlayerAndCycle) {
  play(failing("UNKNOWN", "Exception calling application: my brain hurts"));
  EXPECT_EQ(played_.exit_code, 0) << played_.err;

  expect_warning(
      "brain: player 9: GetPlayerActions failed at cycle 5: UNKNOWN: Exception calling "
      "application: my brain hurts");
  EXPECT_EQ(result_["right"]["errors"]["count"], 1);
  EXPECT_EQ(result_["right"]["errors"]["first"],
            json({{"rpc", "GetPlayerActions"},
                  {"status", "UNKNOWN"},
                  {"message", "Exception calling application: my brain hurts"},
                  {"cycle", 5},
                  {"unum", 9},
                  {"recording", "right-error.rpc"}}));
  EXPECT_EQ(result_["left"]["errors"], json({{"count", 0}, {"first", nullptr}}));

  expect_printed("  brain: 1 RPC error, the first at cycle 5 (GetPlayerActions, player 9)\n");
  expect_printed("try again: cls test --replay " +
                 (folder_.path() / "match/right-error.rpc").string() + " mock:");
}

TEST_F(PlaymakerErrors, CountsErrorsOfAllPlayers) {
  play(script("all", R"({"otherwise": "hold", "faults": {"error": 1,
                         "only": {"cycle": [5, 6]}}})"));
  EXPECT_EQ(result_["right"]["errors"]["count"], 24);
  EXPECT_EQ(result_["right"]["errors"]["first"]["unum"], 1) << "the lowest number in the cycle";
  EXPECT_EQ(result_["right"]["errors"]["first"]["cycle"], 5);
}

TEST_F(PlaymakerErrors, ReplaysStateOfFirstError) {
  const std::string failing = this->failing("UNKNOWN", "my brain hurts");
  play(failing);
  EXPECT_THAT(
      replay("match/right-error.rpc", failing),
      Prints(1, HasSubstr("cycle 5 (step 1), player 9, GetPlayerActions:\n"
                          "    fails as when recorded: GetPlayerActions: my brain hurts\n")));
  EXPECT_THAT(replay("match/right-error.rpc", "mock:hold"),
              Prints(0, HasSubstr(", 0 different, 1 skipped\n"
                                  "(no reply to compare with was recorded; now 1 with a reply, 0 "
                                  "without)\n")));
}

TEST_F(PlaymakerErrors, ExplainsReturnValueOfWrongType) {
  play(failing("INTERNAL", "Failed to serialize response!"));
  expect_warning(
      "INTERNAL: Failed to serialize response! (the method returned no PlayerActions: its return "
      "value has the wrong type)");
}

TEST_F(PlaymakerErrors, NamesUnreadableReply) {
  play(script("garbage", R"({"otherwise": "hold", "faults": {"garbage": 1,
                             "only": {"cycle": [5, 5], "unum": 9}}})"));
  expect_warning(
      "player 9: GetPlayerActions failed at cycle 5: unreadable reply: reply of 64 bytes");
}

TEST_F(PlaymakerErrors, NamesErrorsOfCoach) {
  play(script("coach", R"({"otherwise": "hold", "faults": {"error": 1, "message": "no bench",
                           "only": {"cycle": [5, 5], "unum": 12}}})"));
  expect_warning("the coach: GetCoachActions failed at cycle 5: UNKNOWN: no bench");
}

TEST_F(PlaymakerErrors, QuotesExceptionInOutputOfProgram) {
  play(
      "run:printf 'Traceback (most recent call last):\\n  File \"b.py\"\\nValueError: no ball\\n'; "
      "exec " +
      cls_binary().string() + " mock hold --port {port}");
  EXPECT_EQ(played_.exit_code, 0) << played_.err;
  expect_warning("right Playmaker printed an exception: ValueError: no ball");
  EXPECT_EQ(result_["processes"][0]["exception"], "ValueError: no ball");
  expect_printed("  right Playmaker: ValueError: no ball\n    output is in " +
                 (folder_.path() / "match/right-playmaker.log").string() + "\n");
}

// Once while the match is played, and once in the summary.
TEST_F(PlaymakerErrors, ReportsExceptionOfFailedCallOnce) {
  const std::string program = folder_.path() / "playmaker.sh";
  std::ofstream(program) << "printf 'Traceback (most recent call last):\\n  File \"b.py\"\\n"
                            "ValueError: my brain hurts\\n'\nexec '"
                         << cls_binary().string()
                         << "' mock hold --port \"$1\" --error 1 --message "
                            "'ValueError: my brain hurts' --fault-unum 9 --fault-cycles 5 5\n";

  play("run:sh '" + program + "' {port}");
  const auto count = [](const std::string& text) {
    std::size_t times = 0;
    for (std::size_t at = text.find("my brain hurts"); at != std::string::npos;
         at = text.find("my brain hurts", at + 1)) {
      ++times;
    }
    return times;
  };

  EXPECT_EQ(count(played_.err), 1u) << played_.err;
  EXPECT_EQ(count(played_.out), 1u) << played_.out;
  expect_printed("    output is in " + (folder_.path() / "match/right-playmaker.log").string());
}

TEST_F(PlaymakerErrors, WarnsOfNumbersThatAreNotFinite) {
  play(script("nan", R"({"rules": [{"reply": {"ignore_preprocess": true, "actions": [
                           {"dash": {"power": "NaN"}},
                           {"body_go_to_point": {"target_point": {"x": "Infinity"}}}]}}]})"));
  expect_warning(
      "the Playmaker sends action dash with a number that is not finite (NaN or infinity): "
      "ignored");
  expect_warning("the Playmaker sends action body_go_to_point with a number that is not finite");
  const json& player = result_["right"]["players"][4];
  EXPECT_GT(player["actions"]["dash"]["invalid"], 10);
  EXPECT_EQ(player["actions"]["dash"].size(), 1U) << player["actions"];
  EXPECT_EQ(player["replies"]["useless"], player["replies"]["tried"]);
  expect_printed("invalid or unknown");
}

TEST_F(PlaymakerErrors, WarnsOfUselessReplies) {
  play(script("empty", R"({"rules": [{"reply": {"ignore_preprocess": true}}]})"));
  expect_warning(" replies had no executable action (");
  EXPECT_EQ(result_["right"]["players"][0]["replies"]["empty"],
            result_["right"]["players"][0]["replies"]["tried"]);
  play(script("no_ball", R"({"rules": [{"reply": {"ignore_preprocess": true, "actions": [
                               {"body_hold_ball": {}}]}}]})"));
  expect_warning("; most often failed: body_hold_ball (ball not kickable)");
  play("mock");
  EXPECT_EQ(result_["warnings"].size(), 0U) << warnings();
}

TEST_F(PlaymakerErrors, CountsActionsByOutcome) {
  play(script("twice", R"({"rules": [{"reply": {"ignore_preprocess": true, "actions": [
                             {"body_kick_one_step": {"first_speed": 1}},
                             {"turn": {"relative_direction": 10}}, {"dash": {"power": 10}}]}}]})"),
       {"--set", "server::kick_off_wait=0"});
  const json& actions = result_["right"]["players"][4]["actions"];
  EXPECT_GT(actions["body_kick_one_step"]["failed"], 10) << actions;
  EXPECT_GT(actions["turn"]["executed"], 10);
  EXPECT_EQ(actions["dash"]["skipped"], actions["turn"]["executed"]);
  expect_printed("  actions executed ");
  expect_printed("  failed, skipped ");
}

TEST_F(PlaymakerErrors, SaysTheErrorOfAnInvalidMatchOnce) {
  play(script("broken", R"-({"otherwise": "hold", "faults": {"error": 1, "status": "UNKNOWN",
    "message": "ValueError: no plan (team.py:4)"}})-"),
       {"--set", "server::kick_off_wait=50"});
  EXPECT_EQ(result_["end_reason"], "protocol_error");

  const auto count = [](const std::string& text) {
    int times = 0;
    for (std::size_t at = text.find("no plan"); at != std::string::npos; ++times) {
      at = text.find("no plan", at + 1);
    }
    return times;
  };

  EXPECT_EQ(count(played_.err), 1) << played_.err;
  EXPECT_EQ(count(played_.out), 1) << played_.out;
  EXPECT_THAT(played_.err, HasSubstr("no usable reply to 21 calls in a row, at cycle 0: "));
  EXPECT_THAT(played_.out, testing::Not(HasSubstr("rpc p50"))) << "no figures of no cycle";
  EXPECT_THAT(played_.out, testing::Not(HasSubstr("real time")));
}

}  // namespace
}  // namespace cls::tests
