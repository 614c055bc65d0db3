// End-to-end tests of `cls test`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/junit.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

CommandResult cls_test(const std::vector<std::string>& arguments) {
  // All shipped scenarios take seconds, but longer on a loaded host and with sanitizers.
  constexpr std::chrono::seconds kMaxDuration{240};
  return Command(joined({cls_binary(), "test"}, arguments)).finish(kMaxDuration);
}

// The parts of the document that must be reproducible: all except times.
base::Json timeless(const std::string& text) {
  auto json = base::Json::parse(text);
  auto scenarios = base::Json::array();
  for (base::Json scenario : json["scenarios"]) {
    scenario.erase("seconds");
    scenarios.push_back(scenario);
  }
  json["scenarios"] = scenarios;
  return json;
}

TEST(TestCommand, ShippedScenariosPassIdenticallyUnderLoad) {
  TemporaryFolder folder;
  const std::string dir = folder.path();
  const auto alone = cls_test({"--json", "--quiet", "--dir", dir, "--jobs", "1"});
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  // Twice as many parallel runs as processor cores, beside a busy thread.
  Command load({"/bin/sh", "-c", "while :; do :; done"});
  const auto loaded = cls_test({"--json", "--quiet", "--dir", dir, "--jobs", "4"});
  EXPECT_EQ(loaded.exit_code, 0) << loaded.err;
  ASSERT_FALSE(alone.out.empty());
  EXPECT_EQ(timeless(alone.out), timeless(loaded.out));
  EXPECT_GE(timeless(alone.out)["passed"].get<int>(), 30);
}

TEST(TestCommand, ReportsAndStoresFailuresForRerun) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "no_goal.json";
  std::ofstream(file) << R"({"noise": false, "mode": "play_on", "seed": 5,
    "ball": {"at": [45, 0], "velocity": [2.5, 0]},
    "left": {"playmaker": "mock:hold", "players": {"9": {"at": [0, 0]}}},
    "right": {"playmaker": "mock:hold", "players": {"9": {"at": [5, 20]}}},
    "steps": 10,
    "expect": [{"score": [0, 0]}]})";
  const std::string junit = folder.path() / "junit.xml";
  const std::string kept = folder.path() / "kept";
  const auto failed = cls_test({file, "--dir", kept, "--junit", junit, "--github"});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.out, HasSubstr("FAIL  no_goal"));
  EXPECT_THAT(failed.out, HasSubstr("the score is 1 : 0, not == 0 for the left"));
  EXPECT_THAT(failed.out, HasSubstr("rerun: cls test " + file + " --seed 5"));
  EXPECT_EQ(failed.err.rfind("::error file=", 0), 0u) << failed.err;
  EXPECT_THAT(read_file(junit), HasSubstr("<failure "));
  EXPECT_EQ(junit_errors(read_file(junit)).value_or(""), "");

  const fs::path logs = fs::path(kept) / "no_goal-seed-5";
  EXPECT_TRUE(fs::exists(logs / "match.rcg"));

  const std::string from_page = folder.path() / "from_page.rcg";
  run({cls_binary(), "convert", logs / "match.html", from_page});
  EXPECT_EQ(read_file(from_page), read_file(logs / "match.rcg"));
  EXPECT_THAT(read_file(junit), HasSubstr("[[ATTACHMENT|" + (logs / "match.html").string()));
  EXPECT_THAT(run({cls_binary(), "results", logs / "match.rcg"}), Exits(0));

  const auto again = cls_test({file, "--seed", "5", "--dir", kept, "--json"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(timeless(again.out)["scenarios"][0]["checks"][0]["passed"], false);
}

TEST(TestCommand, AddsToTheSummaryOfAJob) {
  TemporaryFolder folder;
  const std::string summary = folder.path() / "summary.md";
  std::ofstream(summary) << "before\n";
  const std::vector<std::string> words = {cls_binary(), "test", "referee_corner_kick", "--dir",
                                          folder.path() / "kept"};
  const std::vector<std::string> environment = {"GITHUB_STEP_SUMMARY=" + summary,
                                                "GITHUB_ACTIONS=true"};
  EXPECT_EQ(run(words, environment).exit_code, 0);
  EXPECT_EQ(read_file(summary), "before\n### cls test: 1 passed, 0 failed, 0 skipped\n\n");
}

TEST(TestCommand, SelectsByNameFilterAndShard) {
  const auto names = [](std::vector<std::string> arguments) {
    arguments.push_back("--list");
    const auto listed = cls_test(arguments);
    EXPECT_EQ(listed.exit_code, 0) << listed.err;
    std::vector<std::string> found;
    for (std::size_t at = 0; at < listed.out.size();) {
      const std::size_t end = listed.out.find('\n', at);
      found.push_back(listed.out.substr(at, listed.out.find(' ', at) - at));
      at = end + 1;
    }
    return found;
  };
  using Names = std::vector<std::string>;

  EXPECT_EQ(names({"--filter", "*corner_kick"}),
            (Names{"referee_corner_kick", "team_takes_a_corner_kick"}));
  EXPECT_EQ(names({"--filter", "eree_onside"}),
            (Names{"referee_onside", "referee_onside_behind_the_ball"}));
  EXPECT_EQ(names({"referee_goal"}), Names{"referee_goal"});

  const Names all = names({});
  Names parts;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    for (const std::string& name : names({"--shard", shard})) parts.push_back(name);
  }

  std::ranges::sort(parts);
  EXPECT_EQ(parts, all);

  const auto unknown = cls_test({"referee_gaol"});
  EXPECT_EQ(unknown.exit_code, 66);
  EXPECT_EQ(unknown.err, "cls: unknown scenario 'referee_gaol'; did you mean 'referee_goal'?\n");
  EXPECT_EQ(cls_test({"--shard", "4/3"}).exit_code, 2);
  EXPECT_EQ(cls_test({"--filter", "nothing_of_this"}).exit_code, 2);
}

TEST(TestCommand, NamesTheScenariosOfTheProject) {
  TemporaryFolder folder;
  const auto listed = [&folder] {
    return Command({cls_binary().string(), "test", "--list", "--filter", "referee_goal"}, {},
                   folder.path())
        .finish();
  };
  std::filesystem::create_directory(folder.path() / "tests");
  EXPECT_EQ(listed().err, "") << "not a project";
  std::ofstream(folder.path() / "cls.toml") << "";
  EXPECT_THAT(listed().err, HasSubstr("those of this folder: cls test tests/\n"));
  EXPECT_THAT(listed().out, testing::StartsWith("referee_goal "));
}

TEST(TestCommand, ReplacesPlaymakerOfSideUnderTest) {
  TemporaryFolder folder;
  const auto hold = cls_test(
      {"team_goes_for_the_ball", "--against", "mock:hold", "--dir", folder.path(), "--seed", "1"});
  EXPECT_EQ(hold.exit_code, 1) << "a player that only observes does not move to the ball";
  EXPECT_THAT(hold.out, HasSubstr("--against 'mock:hold'"));
  EXPECT_THAT(cls_test({"referee_goal", "--against", "mock", "--dir", folder.path()}),
              Prints(0, HasSubstr("skip  referee_goal: no side under test")));
}

TEST(TestCommand, RunsProgramAsSideUnderTest) {
  TemporaryFolder folder;
  const std::string program = "run:" + cls_binary().string() + " mock --port {port}";
  EXPECT_THAT(cls_test({"team_goes_for_the_ball", "team_finds_a_lost_ball", "--against", program,
                        "--dir", folder.path()}),
              Prints(0, HasSubstr("2 passed, 0 failed")));
  EXPECT_THAT(
      cls_test(
          {"team_goes_for_the_ball", "--against", "run:exit 3 # {port}", "--dir", folder.path()}),
      Prints(1, HasSubstr("the run ended as refused, not finished: left (run:exit 3 # {port}): its "
                          "process ended before it answered: exit code 3")));
}

// Noise decides by seed whether the ball ends above or below the line. `runs` as in a check.
void write_roll(const std::string& file, const std::string& runs) {
  std::ofstream(file) << R"({"mode": "play_on", "ball": {"at": [-20, 0], "velocity": [2, 0]},
    "left": {"playmaker": "mock:hold", "players": {"9": {"at": [-40, 30]}}},
    "right": {"playmaker": "mock:hold", "players": {"9": {"at": [40, 30]}}},
    "seeds": 8, "steps": 40, "expect": [{"ball": {"y": {"<": 0}}, "runs": )"
                      << runs << "}]}";
}

TEST(TestCommand, AcceptsChecksThatHoldInSomeSeeds) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "roll.json";
  const auto play = [&](const std::string& runs, const std::vector<std::string>& more = {}) {
    write_roll(file, runs);
    return cls_test(joined({file, "--dir", folder.path() / "kept"}, more));
  };
  EXPECT_EQ(play(R"({"between": [1, 7]})").exit_code, 0);

  for (const char* runs : {R"({">=": 8})", "0"}) {
    const auto failed = play(runs);
    EXPECT_EQ(failed.exit_code, 1) << runs;
    EXPECT_THAT(failed.out, HasSubstr(" of 8 runs, not "));
    // The printed command reruns a single failed run.
    const std::size_t seed = failed.out.find("--seed ");
    ASSERT_NE(seed, std::string::npos) << failed.out;
    const std::string number = failed.out.substr(seed + 7, failed.out.find('\n', seed) - seed - 7);
    EXPECT_EQ(play(runs, {"--seed", number}).exit_code, 1) << runs;
    EXPECT_THAT(failed.out, HasSubstr("      logs: "));
  }

  // A seed in which it does not hold is not a failure if the count allows it.
  EXPECT_EQ(play(R"({"<=": 8})", {"--seed", "1"}).exit_code, 0);

  EXPECT_THAT(cls_test({"physics_noise_spreads_the_ball", "--seed", "3", "--filter", "noise",
                        "--dir", folder.path() / "kept"}),
              Exits(0));
}

std::vector<std::string> folders_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(TestCommand, StoresOnlyRunsOfFailedScenarios) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "roll.json";
  const std::string kept = folder.path() / "kept";
  fs::create_directories(fs::path(kept) / "roll-seed-99");
  std::ofstream(fs::path(kept) / "roll-seed-99/failures.txt") << "of an earlier suite";
  std::ofstream(fs::path(kept) / "notes.txt") << "of the user";
  write_roll(file, "8");
  EXPECT_EQ(cls_test({file, "--dir", kept}).exit_code, 1);
  const auto failed = folders_in(kept);
  EXPECT_GT(failed.size(), 1U);
  EXPECT_EQ(std::ranges::count(failed, "roll-seed-99"), 0);
  write_roll(file, R"({">=": 1})");
  EXPECT_EQ(cls_test({file, "--dir", kept}).exit_code, 0);
  EXPECT_EQ(folders_in(kept), std::vector<std::string>{"notes.txt"});
}

TEST(TestCommand, InterruptIsNoFailure) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "long.json";
  std::ofstream(file) << R"({"mode": "play_on", "left": {"playmaker": "mock"},
    "right": {"playmaker": "mock"}, "steps": 100000, "expect": [{"score": [99, 99]}]})";
  Command testing(
      {cls_binary(), "test", "referee_goal", file, "--jobs", "1", "--dir", folder.path() / "kept"});
  ASSERT_TRUE(testing.wait_for_output("ok    referee_goal", std::chrono::seconds(120)));
  testing.send_signal(SIGINT);
  EXPECT_THAT(
      testing.finish(),
      Prints(130, testing::AllOf(
                      Not(HasSubstr("FAIL")), HasSubstr("1 passed, 0 failed, 0 skipped"),
                      HasSubstr("interrupted: 1 of 2 scenarios were not played to the end\n"))));
}

TEST(TestCommand, NamesBuiltInScenarioWithoutPathThatIsNotThere) {
  TemporaryFolder folder;
  Command testing({cls_binary(), "test", "--against", "mock:hold", "team_takes_a_goal_kick"}, {},
                  folder.path());
  EXPECT_THAT(testing.finish(),
              Prints(1, testing::AllOf(Not(HasSubstr("examples/")),
                                       HasSubstr("      built-in scenario: line "),
                                       HasSubstr("      file: cls test --export DIR writes "
                                                 "DIR/team_takes_a_goal_kick.json\n"))));
}

TEST(TestCommand, AcceptsGoldenValues) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "golden.scenario.json";
  std::ofstream(file) << R"({"mode": "play_on", "steps": 5,
    "left": {"playmaker": "mock:hold", "players": {"9": {"at": [0, 5]}}},
    "right": {"playmaker": "mock:hold", "players": {"9": {"at": [5, 20]}}},
    "expect": [{"golden": "game_log"}]})";
  const std::string dir = folder.path() / "kept";
  EXPECT_EQ(cls_test({file, "--dir", dir}).exit_code, 1);
  EXPECT_THAT(cls_test({file, "--dir", dir, "--accept"}),
              Exits(0, HasSubstr("1 golden values changed")));
  EXPECT_EQ(cls_test({file, "--dir", dir}).exit_code, 0);
  EXPECT_EQ(cls_test({file, "--dir", dir, "--seed", "2"}).exit_code, 1);
}

TEST(TestCommand, ReportsInvalidScenarioWithLine) {
  TemporaryFolder folder;
  const std::string file = folder.path() / "bad.json";
  std::ofstream(file) << "{\n  \"expct\": []\n}";
  EXPECT_THAT(
      cls_test({file}),
      Exits(65, "cls: " + file + ":2: /expct: unknown key 'expct'; did you mean 'expect'?\n"));
  EXPECT_EQ(cls_test({"nowhere/at_all.json"}).exit_code, 66);
}

TEST(TestCommand, ExportsShippedScenarios) {
  TemporaryFolder folder;
  const std::string copies = folder.path() / "copies";
  ASSERT_EQ(cls_test({"--export", copies}).exit_code, 0);
  EXPECT_EQ(cls_test({copies + "/referee_goal.json", "--dir", folder.path()}).exit_code, 0);
}

TEST(TestCommand, ExportReplacesChangedFilesOnlyWithForce) {
  TemporaryFolder folder;
  const std::string copies = folder.path() / "copies";
  ASSERT_EQ(cls_test({"--export", copies}).exit_code, 0);
  EXPECT_EQ(cls_test({"--export", copies}).exit_code, 0) << "nothing has changed";

  const std::string edited = copies + "/referee_goal.json";
  std::ofstream(edited) << "{}";

  EXPECT_THAT(cls_test({"--export", copies}),
              Exits(73, "cls: " + edited +
                            ": differs from the shipped scenario\n"
                            "cls: nothing written; --force renames these files to NAME.old "
                            "first\n"));
  EXPECT_EQ(read_file(edited), "{}");
  EXPECT_THAT(cls_test({"--export", copies, "--force"}),
              Exits(0, "cls: " + edited + " renamed to referee_goal.json.old\n"));
  EXPECT_EQ(read_file(edited + ".old"), "{}");
  EXPECT_NE(read_file(edited), "{}");
}

class Recording : public testing::Test {
 protected:
  std::string folder() const { return folder_.path(); }
  CommandResult match(const std::string& name, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {cls_binary(), "match"});
    arguments.insert(arguments.end(), {"--seed", "11", "--cycles", "40", "--set",
                                       "server::kick_off_wait=3", "--dir", folder() + "/" + name});
    return run(arguments);
  }
  std::string file(const std::string& name) { return read_file(folder() + "/" + name); }

 private:
  TemporaryFolder folder_;
};

TEST_F(Recording, IsReproducibleAndReplaysWithoutDifferences) {
  for (const char* name : {"one", "two"}) {
    ASSERT_THAT(match(name, {"mock", "mock:hold", "--record-rpc", folder() + "/" + name + ".rpc"}),
                Exits(0));
  }
  EXPECT_EQ(file("one.rpc"), file("two.rpc"));
  EXPECT_THAT(cls_test({"--replay", folder() + "/one.rpc", "mock"}),
              Prints(0, HasSubstr(" 0 different")));
}

TEST_F(Recording, ReportsDifferentRepliesOfChangedPlaymaker) {
  ASSERT_THAT(match("match", {"mock:simple", "mock:hold", "--record-rpc", folder() + "/m.rpc"}),
              Exits(0));

  std::ofstream(folder() + "/changed.json") << R"({"otherwise": "simple", "rules":
      [{"when": {"unum": 5, "cycle": 20}, "reply": [{"dash": {"power": 33}}]}]})";
  const auto changed =
      cls_test({"--replay", folder() + "/m.rpc", "mock:" + folder() + "/changed.json", "--json"});
  EXPECT_EQ(changed.exit_code, 1) << changed.err;

  const auto json = base::Json::parse(changed.out);
  EXPECT_EQ(json["schema"], "cls.replay/1");
  ASSERT_EQ(json["different"], 1);
  EXPECT_EQ(json["differences"][0]["cycle"], 20);
  EXPECT_EQ(json["differences"][0]["agent"], 5);
  EXPECT_THAT(json["differences"][0]["fields"].dump(), HasSubstr("dash"));
  EXPECT_THAT(cls_test({"--replay", folder() + "/m.rpc", "mock:hold", "--side", "right"}),
              Exits(0));
}

TEST_F(Recording, SendsOneDecisionAgain) {
  ASSERT_THAT(match("match", {"mock:simple", "mock:hold", "--record-rpc", folder() + "/m.rpc"}),
              Exits(0));

  std::ofstream(folder() + "/changed.json") << R"({"otherwise": "simple", "rules":
      [{"when": {"unum": 5}, "reply": [{"dash": {"power": 33}}]}]})";
  const std::string changed = "mock:" + folder() + "/changed.json";
  const auto replay = [&](const std::vector<std::string>& more) {
    return cls_test(joined({"--replay", folder() + "/m.rpc", changed, "--json"}, more));
  };
  const auto one = replay({"--at", "20", "--player", "5"});
  EXPECT_EQ(one.exit_code, 1) << one.err;

  const auto json = base::Json::parse(one.out);
  EXPECT_EQ(json["different"], 1);
  EXPECT_EQ(json["differences"][0]["cycle"], 20);
  EXPECT_LT(json["calls"].get<int>(), 40);  // with the handshake of player 5
  EXPECT_THAT(replay({"--at", "20", "--player", "6"}), Exits(0));
  EXPECT_THAT(replay({"--at", "99999", "--player", "5"}),
              Exits(65, HasSubstr("no decision of player 5 in cycle 99999 of the left side")));
  EXPECT_EQ(cls_test({"--player", "5"}).exit_code, 2);
}

TEST_F(Recording, ServesAsBehaviorOfMock) {
  ASSERT_EQ(match("played", {"mock", "mock", "--record-rpc", folder() + "/m.rpc"}).exit_code, 0);
  const std::string again = "mock:replay:" + folder() + "/m.rpc";
  ASSERT_THAT(match("again", {again, again, "--left-name", "mock_l", "--right-name", "mock_r"}),
              Exits(0));
  EXPECT_EQ(file("played/match.rcg"), file("again/match.rcg"));
}

TEST_F(Recording, ReportsCorruptRecording) {
  ASSERT_EQ(match("match", {"mock", "mock", "--record-rpc", folder() + "/m.rpc"}).exit_code, 0);
  const std::string whole = file("m.rpc");
  fs::resize_file(folder() + "/m.rpc", fs::file_size(folder() + "/m.rpc") / 2);
  EXPECT_THAT(cls_test({"--replay", folder() + "/m.rpc", "mock"}),
              Exits(65, HasSubstr("corrupt or truncated after call")));
  std::ofstream(folder() + "/text.rpc") << "no recording";
  EXPECT_THAT(cls_test({"--replay", folder() + "/text.rpc", "mock"}),
              Exits(65, HasSubstr("not an RPC recording")));
  EXPECT_EQ(cls_test({"--replay", folder() + "/none.rpc", "mock"}).exit_code, 66);
  EXPECT_EQ(cls_test({"--replay", folder() + "/m.rpc"}).exit_code, 2);
}

TEST_F(Recording, OfTheNameOfAHostIsNotBlamedForItsPlaymaker) {
  ASSERT_EQ(match("match", {"mock", "mock", "--record-rpc", folder() + "/localhost"}).exit_code, 0);

  const std::vector<std::string> replay = {
      cls_binary(), "test", "--replay", "localhost", "localhost:1", "--start-timeout", "0.3"};
  EXPECT_THAT(Command(replay, {}, folder()).finish(), Exits(69, HasSubstr("localhost:1")));
}

TEST_F(Recording, WritesDebugActionsByCycleAndUnum) {
  std::ofstream(folder() + "/talk.json") << R"({"rules": [
    {"when": {"cycle": [5, 6], "unum": [3, 9]},
     "reply": [{"log": {"add_text": {"level": "TEAM", "message": "hello"}}},
               {"log": {"add_circle": {"center": {"x": 1, "y": 2}, "radius": 3, "color": "red"}}},
               {"debug_client": {"message": "for the viewer"}}]}]})";
  ASSERT_THAT(match("talk", {"mock:" + folder() + "/talk.json", "mock:hold"}),
              Exits(0, Not(HasSubstr("does not have"))));

  const std::string lines = file("talk/left-debug.jsonl");
  EXPECT_EQ(lines.rfind("{\"t\":5,\"unum\":3,\"kind\":\"text\",\"level\":\"TEAM\",\"message\":"
                        "\"hello\"}\n"
                        "{\"t\":5,\"unum\":3,\"kind\":\"circle\",\"center\":",
                        0),
            0u)
      << lines;
  EXPECT_EQ(std::ranges::count(lines, '\n'), 12);
  EXPECT_FALSE(fs::exists(folder() + "/talk/right-debug.jsonl"));

  // Every page of the match has them, and says which frame they belong to.
  const std::string page = folder() + "/page.html";
  ASSERT_THAT(run({cls_binary(), "watch", folder() + "/talk", "--out", page}), Exits(0));
  EXPECT_THAT(file("page.html"), HasSubstr("id=\"drawings-left\""));
  EXPECT_THAT(file("page.html"), Not(HasSubstr("id=\"drawings-right\"")));
}

TEST_F(Recording, WritesDebugActionsOfAStoppedClockWithItsCycles) {
  std::ofstream(folder() + "/talk.json") << R"({"rules": [
    {"when": {"cycle": [0, 0], "unum": [3, 3]}, "reply": [{"debug_client": {"message": "x"}}]}]})";
  ASSERT_THAT(match("talk", {"mock:" + folder() + "/talk.json", "mock:hold"}), Exits(0));
  EXPECT_THAT(file("talk/left-debug.jsonl"), HasSubstr("{\"t\":0,\"stopped\":"));
}

// Eleven players, 30 cycles, 60 kB each: 20 MB.
TEST_F(Recording, LimitsSizeOfDebugActions) {
  std::ofstream(folder() + "/flood.json")
      << R"({"rules": [{"reply": [{"debug_client": {"message": ")" << std::string(60'000, 'x')
      << R"("}}]}]})";
  ASSERT_THAT(match("flood", {"mock:" + folder() + "/flood.json", "mock:hold"}), Exits(0));
  const std::string lines = file("flood/left-debug.jsonl");
  EXPECT_GT(lines.size(), 10'000'000u);
  EXPECT_LT(lines.size(), 10'500'000u);
  const std::size_t last = lines.rfind("{\"kind\":\"omitted\",\"count\":");
  ASSERT_NE(last, std::string::npos);
  EXPECT_EQ(lines.find('\n', last), lines.size() - 1);
}

TEST_F(Recording, StepsThroughMatchCycleByCycle) {
  // The shell sends the lines that a user would type.
  const std::string command = std::string(cls_binary()) +
                              " match mock:hold mock:hold --seed 1 --at 10 --cycles 30 --set "
                              "server::kick_off_wait=3 --dir " +
                              folder() + "/steps";
  const auto walked = run({"/bin/sh", "-c", "printf '\\n3\\nx\\nq\\n' | " + command});
  EXPECT_EQ(walked.exit_code, 0) << walked.err;
  EXPECT_THAT(walked.err, HasSubstr("cycle 10 "));
  EXPECT_THAT(walked.err, HasSubstr("cycle 11 "));
  EXPECT_THAT(walked.err, Not(HasSubstr("cycle 12 ")));
  EXPECT_THAT(walked.err, HasSubstr("cycle 14 "));
  EXPECT_THAT(walked.err, HasSubstr("Enter: one cycle"));
  EXPECT_THAT(walked.err, Not(HasSubstr("cycle 15 ")));
  EXPECT_THAT(run({"/bin/sh", "-c", "printf 'c\\n' | " + command + "-again"}),
              Prints(0, HasSubstr("30 cycles")));
}

TEST_F(Recording, StepContinuesAtEndOfInput) {
  const std::string command = std::string(cls_binary()) +
                              " match mock:hold mock:hold --seed 1 --step --cycles 3 --set "
                              "server::kick_off_wait=3 --dir " +
                              folder() + "/steps";
  const auto walked = run({"/bin/sh", "-c", "printf '\\n2\\n' | " + command});
  EXPECT_EQ(walked.exit_code, 0) << walked.err;
  EXPECT_EQ(walked.err.rfind("cycle 0", 0), 0u) << walked.err;
  EXPECT_THAT(walked.err, HasSubstr(" before_kick_off  0 : 0"));
  EXPECT_THAT(walked.out, HasSubstr("3 cycles"));
}

// A Playmaker stopped at a breakpoint replies after every deadline.
TEST_F(Recording, AcceptsLateRepliesWithoutDeadline) {
  std::ofstream(folder() + "/slow.json")
      << R"({"faults": {"delay_ms": 150, "only": {"cycle": [1, 2], "unum": 7}}})";
  const std::string slow = "mock:" + folder() + "/slow.json";
  const auto late = match("late", {slow, "mock:hold", "--rpc-deadline", "20"});
  EXPECT_EQ(late.exit_code, 0) << late.err;
  const auto missed = [this](const char* name) {
    return base::Json::parse(
               file(std::string(name) + "/result.json"))["left"]["players"][6]["missed"]
        .get<int>();
  };
  EXPECT_GE(missed("late"), 1);
  const auto patient = match("patient", {slow, "mock:hold", "--no-deadline"});
  EXPECT_EQ(patient.exit_code, 0) << patient.err;
  EXPECT_EQ(missed("patient"), 0);
}

// A folder with a team in its cls.toml and a scenario in tests/ that names it.
TEST(TestCommand, PlaysTeamsOfTheConfigurationAboveTheScenario) {
  TemporaryFolder folder;
  fs::create_directories(folder.path() / "ada/tests");
  std::ofstream(folder.path() / "ada/cls.toml") << "[teams.ada]\nendpoint = \"mock:press.json\"\n";
  std::ofstream(folder.path() / "ada/press.json") << R"({"otherwise": "hold"})";
  const std::string file = folder.path() / "ada/tests/stands.json";
  const auto write = [&file](const std::string& name) {
    std::ofstream(file) << R"({"mode": "play_on", "ball": {"at": [30, 0]}, "steps": 10,
      "left": {"playmaker": ")" +
                               name + R"(", "players": {"9": {"at": [0, 0]}}},
      "right": {"playmaker": "mock:hold", "players": {"9": {"at": [40, 20]}}},
      "under_test": "left", "expect": [{"commands": "dash", "side": "left", "count": 0}]})";
  };

  write("ada");
  EXPECT_THAT(cls_test({file, "--dir", folder.path() / "kept"}), Exits(0));

  write("adda");
  EXPECT_THAT(cls_test({file, "--dir", folder.path() / "kept"}),
              Exits(65, HasSubstr("stands.json:2: /left/playmaker: unknown side 'adda'; did you "
                                  "mean 'ada'? (a team in ")));
}

// The first start of a project may build it.
TEST(TestCommand, GivesProgramsTheStartTimeOfTheConfiguration) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "cls.toml")
      << "[tournament]\nstart_timeout = 1.5\n"
         "[teams.ada]\nendpoint = \"run:: {port}; exec sleep 100\"\n";
  Command test({cls_binary(), "test", "team_stays_on_the_pitch", "--against", "ada", "--seed", "1"},
               {}, folder.path());
  EXPECT_THAT(test.finish(), Prints(1, HasSubstr("within the start limit of 1.5 s")));

  Command other({cls_binary(), "test", "team_stays_on_the_pitch", "--against", "ada", "--seed", "1",
                 "--start-timeout", "0.5"},
                {}, folder.path());
  EXPECT_THAT(other.finish().out, HasSubstr("within the start limit of 0.5 s (--start-timeout)"));
}

TEST(TestCommand, SaysWhetherAFileOrAFolderIsMissing) {
  EXPECT_THAT(cls_test({"none/"}).err, HasSubstr("none/: no such folder"));
  EXPECT_THAT(cls_test({"none.json"}).err, HasSubstr("none.json: no such file"));
}

// High-level teams use helios_goalie.
TEST(TestCommand, LetsTeamsWithTheBundledGoalieStayOnThePitch) {
  TemporaryFolder folder;
  EXPECT_THAT(
      cls_test({"team_stays_on_the_pitch", "--against", "mock:planner", "--dir", folder.path()}),
      Exits(0));
}

}  // namespace
}  // namespace cls::tests
