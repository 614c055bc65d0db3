// Scripted coaches and trainers in full matches, verified by logs and results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

constexpr const char* kCoach = R"({
  "rules": [{"rpc": "GetCoachActions",
             "reply": [{"do_helios_substitute": {}}, {"do_helios_say_player_types": {}}]}],
  "otherwise": "simple",
  "expect": [{"rpc": "SendPlayerType", "count_per_agent": 18},
             {"rpc": "GetCoachActions", "when": {"unum": 12}, "count": {">": 100}},
             {"rpc": "GetCoachActions", "always": {"self": {"present": false}, "ball.pos_count": 0}}]
})";

// At cycle 10 the ball lies in front of the right goal and rolls in.
constexpr const char* kTrainer = R"({
  "rules": [
    {"rpc": "GetTrainerActions", "when": {"cycle": 10, "mode": "PlayOn"},
     "reply": [{"do_move_ball": {"position": {"x": 51.5, "y": 3}, "velocity": {"x": 2.5}}}]},
    {"rpc": "GetTrainerActions", "when": {"mode": "KickOff", "cycle": [5, 9]},
     "reply": [{"do_change_mode": {"game_mode_type": "PlayOn"}}]}
  ],
  "otherwise": "hold"
})";

class Sideline : public testing::Test {
 protected:
  std::string script(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file) << text;
    return "mock:" + file.string();
  }
  std::string folder(const std::string& name) const { return folder_.path() / name; }

  /// Result document of a finished match.
  json play(const std::string& left, const std::string& right, Arguments more,
            const std::string& name = "match") {
    const auto played = run(
        joined({cls_binary(), "match", left, right, "--seed", "7", "--json", "--dir", folder(name)},
               more));
    EXPECT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(played.err, "");
    return json::parse_or_discarded(played.out);
  }

  std::string log(const std::string& name, const char* file) const {
    return read_file(std::filesystem::path(folder(name)) / file);
  }

  const TemporaryFolder folder_;
};

TEST_F(Sideline, SubstitutesPlayersReproducibly) {
  const std::string side = script("coach.json", kCoach);
  const Arguments more = {"--cycles", "80", "--set", "server::kick_off_wait=30"};
  const json result = play(side, side, more, "one");
  for (const char* team : {"left", "right"}) {
    const json& coach = result[team]["coach"];
    EXPECT_EQ(coach["unum"], 12);
    EXPECT_GT(coach["decisions"], 100);
    EXPECT_EQ(coach["missed"], 0);
    EXPECT_EQ(coach["commands"]["change_player_type"], 11);
  }

  EXPECT_EQ(result["warnings"], json::array());
  EXPECT_EQ(result["deterministic"], true);
  EXPECT_THAT(log("one", "match.rcl"), HasSubstr("_Coach: (change_player_type 11 "));

  play(side, side, more, "two");
  for (const char* file : {"match.rcg", "match.rcl", "events.jsonl"}) {
    EXPECT_TRUE(log("one", file) == log("two", file)) << file;
  }
}

TEST_F(Sideline, IgnoresUnimplementedCoachRpcs) {
  const std::string side = script("none.json", R"({
    "otherwise": "simple", "faults": {"unimplemented": ["GetCoachActions"]}})");
  const json result = play(side, "mock", {"--cycles", "20", "--set", "server::kick_off_wait=3"});
  EXPECT_EQ(result["warnings"], json::array());
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["left"]["coach"]["decisions"], 0);
  EXPECT_GT(result["right"]["coach"]["decisions"], 20);
}

TEST_F(Sideline, ConnectsNoCoachWithNoCoachOption) {
  const json result =
      play("mock", "mock", {"--cycles", "10", "--no-coach", "--set", "server::kick_off_wait=3"});
  EXPECT_EQ(result["left"]["coach"], nullptr);
  EXPECT_THAT(log("match", "match.rcl"), Not(HasSubstr("Coach")));
}

TEST_F(Sideline, TrainerMovesBallInLockstepAndOverUdp) {
  const std::string trainer = script("trainer.json", kTrainer);
  for (const char* mode : {"lockstep", "synch"}) {
    const json result = play("mock:hold", "mock:hold",
                             {"--cycles", "40", "--mode", mode, "--trainer", trainer, "--no-coach",
                              "--set", "server::kick_off_wait=3"},
                             mode);
    EXPECT_EQ(result["left"]["score"], 1) << mode;
    EXPECT_EQ(result["trainer"]["unum"], 13);
    EXPECT_EQ(result["trainer"]["missed"], 0);
    EXPECT_EQ(result["trainer"]["commands"]["move"], 1) << mode;
    EXPECT_EQ(result["warnings"], json::array()) << mode;
  }
}

TEST_F(Sideline, CoachAndTrainerWorkOnRcssserver) {
  const std::string server = rcssserver_program();
  if (server.empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const std::string side = script("coach.json", kCoach);
  const json result = play(side, "mock:hold",
                           {"--cycles", "40", "--server", server, "--trainer",
                            script("trainer.json", kTrainer), "--set", "server::kick_off_wait=30"});
  EXPECT_EQ(result["left"]["coach"]["commands"]["change_player_type"], 11);
  EXPECT_EQ(result["trainer"]["commands"]["move"], 1);
  EXPECT_EQ(result["left"]["score"], 1);
  EXPECT_EQ(result["warnings"], json::array());
}

TEST_F(Sideline, ReportsInvalidOptions) {
  EXPECT_THAT(
      run({cls_binary(), "match", "mock", "mock", "--trainer", "team:/tmp", "--dir", folder("x")}),
      Exits(2, HasSubstr("--trainer 'team:/tmp'")));
  EXPECT_THAT(run({cls_binary(), "match", "mock", "mock", "--left-formation", "no/such/folder",
                   "--dir", folder("x")}),
              Exits(2, HasSubstr("--left-formation: ")));
}

// Other formations change the kick-off positions; the built-in ones read from files change nothing.
TEST_F(Sideline, UsesFormationsOfEachSide) {
  const std::filesystem::path built_in = source_folder() / "player" / "formation" / "built_in";
  for (const char* name : {"same", "other"}) {
    std::filesystem::copy(built_in, folder_.path() / name);
  }
  std::filesystem::copy_file(built_in / "defense-formation.formation",
                             folder_.path() / "other" / "before-kick-off.formation",
                             std::filesystem::copy_options::overwrite_existing);
  const auto game_log = [&](const std::string& name, Arguments more) {
    more.insert(more.end(), {"--cycles", "1", "--set", "server::kick_off_wait=12"});
    play("mock:planner", "mock:planner", more, "match-" + name);
    return log("match-" + name, "match.rcg");
  };
  const std::string plain = game_log("plain", {});
  EXPECT_TRUE(plain == game_log("same", {"--formation", folder("same")}));
  EXPECT_FALSE(plain == game_log("other", {"--left-formation", folder("other"), "--quiet"}));
}

}  // namespace
}  // namespace cls::tests
