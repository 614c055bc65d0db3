// The result document, the match folder and the events file.
#include "match/result/match_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "match/result/event_recorder.h"
#include "match/result/match_folder.h"
#include "match/terms/option_table.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

MatchResult two_to_one() {
  MatchResult result;
  result.left.name = "a";
  result.left.score = 2;
  result.right.name = "b";
  result.right.score = 1;
  return result;
}

TEST(MatchResult, HasWinnerOnlyIfValid) {
  MatchResult result = two_to_one();
  EXPECT_EQ(winner(result), "left");
  result.end_reason = EndReason::kCrashed;
  EXPECT_FALSE(winner(result));
  result = two_to_one();
  result.right.score = 2;
  EXPECT_EQ(winner(result), "draw");
  result.left.penalty_score = 3;
  result.right.penalty_score = 4;
  EXPECT_EQ(winner(result), "right");
}

TEST(MatchResult, WritesMembersOfTheSchema) {
  MatchResult result = two_to_one();
  PlayerResult player;
  player.unum = 1;
  player.commands["dash"] = 3;
  result.left.players.push_back(player);
  result.goals.push_back({17, soccer::Side::kLeft, 9});
  const auto document = base::Json::parse(to_json(result));

  EXPECT_EQ(document["schema"], "cls.match/1");

  for (const char* key : {"left", "right", "winner", "valid", "end_reason", "cycles", "steps",
                          "seed", "mode", "deterministic", "server", "wall_seconds",
                          "cycles_per_second", "log_files", "warnings", "versions"}) {
    EXPECT_TRUE(document.contains(key)) << key;
  }
  EXPECT_EQ(document["winner"], "left");
  EXPECT_EQ(document["end_reason"], "finished");
  EXPECT_EQ(document["left"]["players"][0]["commands"]["dash"], 3);
  EXPECT_TRUE(document["left"]["penalty_score"].is_null());
  EXPECT_EQ(document["goals"][0]["unum"], 9);
  EXPECT_TRUE(document["log_files"]["rcg"].is_null());
}

TEST(MatchResult, ReplacesInvalidUtf8) {
  MatchResult result = two_to_one();
  result.message = "it said \xff\xfe";
  EXPECT_TRUE(base::Json::parse_or_discarded(to_json(result)).is_object());
}

// Every member with a value of its own.
PlayerResult full_player() {
  PlayerResult player;
  player.unum = 1;
  player.decisions = 100;
  player.late = 2;
  player.missed = 3;
  player.missed_by = {{"deadline", 2}, {"error", 1}};
  player.reconnects = 4;
  player.undecided = 5;
  player.lost_commands = 6;
  player.late_wakeups = 7;
  player.rpc_us = {10.4, 20.5, 30.6, 40.7};
  player.commands = {{"dash", 3}, {"turn", 4}};
  player.unimplemented_actions = {{"smart_kick", 1}};
  player.actions = {{"dash", {{"executed", 3}, {"failed", 1}}}};
  player.automatic = {{"preprocess", 8}};
  player.lists = 9;
  player.empty = 10;
  player.useless = 11;
  return player;
}

MatchResult full_result() {
  const PlayerResult player = full_player();
  MatchResult result = two_to_one();
  result.left.endpoint = "mock";
  result.left.penalty_score = 3;
  result.right.penalty_score = 2;
  result.left.cpu_seconds = 1.2345678;
  result.left.players = {player};
  result.left.coach = player;
  result.left.errors.count = 12;
  result.left.errors.first = {"GetPlayerActions", "UNKNOWN", "no ball", 50, 9, "left-error.rpc"};
  result.trainer = player;

  result.end_reason = EndReason::kServerFailed;
  result.message = "the server \xff crashed";
  result.fault = soccer::Side::kNeutral;
  result.failure = ProcessFailure{"soccer server", "exit code 3", "server.log", {"one", "two"}};

  result.cycles = 77;
  result.steps = 78;
  result.seed = 18446744073709551615u;
  result.mode = "realtime";
  result.deterministic = false;
  result.server_kind = "rcssserver";
  result.server_version = "19.0.0";
  result.server_seed = 5;
  result.server_missed_cycles = 6;
  result.server_cpu_seconds = 0.5;
  result.wall_seconds = 7.1239;
  result.cycles_per_second = 83.27;

  result.goals = {{17, soccer::Side::kLeft, 9}, {18, soccer::Side::kRight, 0}};
  result.warnings = {"a warning"};
  result.processes = {
      {"soccer server", "rcssserver", "server.log", "exit code 3", 0.25, 0.0, "KeyError: 7", ""}};
  result.rcg = "match.rcg";
  result.rcl = "match.rcl";
  result.folder = "runs/1";
  return result;
}

TEST(MatchResult, RoundTripsThroughItsDocument) {
  for (const MatchResult& result : {full_result(), two_to_one(), MatchResult()}) {
    const std::string document = to_json(result);
    const auto parsed = parse_match_result(document);
    ASSERT_TRUE(parsed) << parsed.error().message;
    EXPECT_EQ(to_json(*parsed), document);
    EXPECT_EQ(parsed->server_seed, result.server_seed);
  }
  auto next_version = two_to_one();
  next_version.cls_version = "9.9.9";
  EXPECT_EQ(parse_match_result(to_json(next_version))->cls_version, "9.9.9");
}

TEST(MatchResult, ParsesDocumentsWithMissingMembers) {
  const auto parsed = parse_match_result(
      R"({"schema": "cls.match/1", "end_reason": "stalled", "log_files": {"rcg": "a.rcg"}})");
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->end_reason, EndReason::kStalled);
  EXPECT_EQ(parsed->rcg, "a.rcg");
}

TEST(MatchResult, RejectsOtherDocuments) {
  for (const char* text :
       {"", "[1]", "7", "{}", R"({"schema": "cls.match/2", "end_reason": "finished"})",
        R"({"schema": "cls.match/1"})", R"({"schema": "cls.match/1", "end_reason": "exploded"})",
        R"({"schema": "cls.match/1", "end_reason": "finished", "cycles": "x"})",
        R"({"schema": "cls.match/1", "end_reason": "finished", "log_files": 7})"}) {
    EXPECT_FALSE(parse_match_result(text)) << text;
  }
}

TEST(MatchFolder, IsCreatedAndNamedInErrors) {
  const tests::TemporaryFolder folder;
  const fs::path base = folder.path();
  MatchOptions options;
  options.folder = base / "a" / "b";
  EXPECT_EQ(*make_match_folder(options, {"l", "r"}), options.folder);
  EXPECT_TRUE(fs::is_directory(options.folder));
  EXPECT_TRUE(base::write_file(base / "file", "x"));
  options.folder = base / "file" / "c";
  const auto refused = make_match_folder(options, {"l", "r"});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message,
              HasSubstr("cannot create folder " + options.folder.string()));
}

TEST(MatchFolder, IsDistinctForMatchesInTheSameSecond) {
  const tests::TemporaryFolder base;
  const fs::path before = fs::current_path();
  fs::current_path(base.path());
  const auto first = make_match_folder(MatchOptions{}, {"l", "r"});
  const auto second = make_match_folder(MatchOptions{}, {"l", "r"});
  fs::current_path(before);
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
  EXPECT_TRUE(first->string().starts_with("runs/"));
  EXPECT_THAT(first->string(), HasSubstr("Z-l-vs-r"));
}

TEST(Manifest, ListsOnlySettingsThatDifferFromDefaults) {
  MatchOptions options;
  ASSERT_TRUE(apply_setting(options, "server::half_time=10"));
  const auto manifest =
      base::Json::parse(manifest_json(options, {"l", "r"}, 7, {"2026-11-20T10:00:00Z", "", ""}));
  EXPECT_EQ(manifest["seed"], 7);
  const base::Json expected = {{"server::half_time", 10},
                               {"server::nr_extra_halfs", 0},
                               {"server::penalty_shoot_outs", false}};
  EXPECT_EQ(manifest["settings"], expected);
}

TEST(MatchOptions, ReportsInvalidSettingsAndRanges) {
  MatchOptions options;
  EXPECT_EQ(apply_setting(options, "half_time=10").error().message,
            "'half_time=10' must be server::NAME=VALUE or player::NAME=VALUE");
  EXPECT_EQ(apply_setting(options, "sever::half_time=10").error().message,
            "'sever::half_time=10': unknown module 'sever'; must be server or player");
  EXPECT_EQ(apply_setting(options, "player::pt_mx=2").error().message,
            "unknown parameter 'pt_mx'; did you mean 'pt_max'?");
  EXPECT_TRUE(validate_options(options).empty());
  EXPECT_EQ(set_options(options, {{"protocol", "13"}, {"cycles", "0"}}),
            (std::vector<std::string>{"--cycles '0': must be a whole number from 1",
                                      "--protocol '13': must be a whole number from 14 to 19"}));
}

TEST(EventRecorder, WritesGoalsAndPlayModesInOrderOfTime) {
  base::StringSink sink;
  EventRecorder events(sink);
  gamelog::MatchRecord log;
  log.notes.push_back({0, 13, 0, soccer::PlayMode::kKickOffRight});
  MatchResult result;
  result.goals = {{12, soccer::Side::kLeft, 9}};
  result.cycles = 20;
  result.left.score = 1;
  events.start({"A", "B"}, 7);
  events.read_log(log, result);
  events.end(result);
  EXPECT_EQ(
      sink.bytes(),
      R"({"schema":"cls.events/1","seq":0,"t":0,"type":"started","left":"A","right":"B","seed":7}
{"schema":"cls.events/1","seq":1,"t":12,"type":"goal","side":"left","unum":9,"score":[1,0]}
{"schema":"cls.events/1","seq":2,"t":13,"type":"play_mode","mode":"kick_off_r"}
{"schema":"cls.events/1","seq":3,"t":20,"type":"ended","end_reason":"finished","score":[1,0]}
)");
}

TEST(WholeFile, NamesFileThatCannotBeWritten) {
  tests::TemporaryFolder folder;
  EXPECT_TRUE(base::write_file(folder.path() / "a.json", "{}"));
  EXPECT_EQ(tests::read_file(folder.path() / "a.json"), "{}");
  const auto refused = base::write_file(folder.path() / "none" / "a.json", "{}");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace cls::match
