// The result document, the match folder and the events file.
#include "orchestration/match/result/match_result.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/io/whole_file.h"
#include "orchestration/match/result/event_log.h"
#include "orchestration/match/result/match_folder.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::match {
namespace {

namespace fs = std::filesystem;

MatchResult two_to_one() {
  MatchResult result;
  result.left.name = "a";
  result.left.score = 2;
  result.right.name = "b";
  result.right.score = 1;
  return result;
}

TEST(MatchResult, AWinnerNeedsAValidMatch) {
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

TEST(MatchResult, DocumentHasTheContractsMembers) {
  MatchResult result = two_to_one();
  PlayerResult player;
  player.unum = 1;
  player.commands["dash"] = 3;
  result.left.players.push_back(player);
  result.goals.push_back({17, soccer::Side::kLeft, 9});
  const auto document = nlohmann::json::parse(to_json(result));
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

TEST(MatchResult, BytesThatAreNotTextDoNotBreakTheDocument) {
  MatchResult result = two_to_one();
  result.message = "it said \xff\xfe";
  EXPECT_NO_THROW(nlohmann::json::parse(to_json(result)));
}

TEST(MatchFolder, IsMadeAndRefusalsNameIt) {
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
  EXPECT_NE(refused.error().message.find("cannot create folder " + options.folder.string()),
            std::string::npos);
}

TEST(MatchFolder, TwoMatchesOfOneSecondGetFoldersOfTheirOwn) {
  const tests::TemporaryFolder base;
  const fs::path before = fs::current_path();
  fs::current_path(base.path());
  const auto first = make_match_folder(MatchOptions{}, {"l", "r"});
  const auto second = make_match_folder(MatchOptions{}, {"l", "r"});
  fs::current_path(before);
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
  EXPECT_TRUE(first->string().starts_with("runs/"));
  EXPECT_TRUE(first->string().find("Z-l-vs-r") != std::string::npos);
}

TEST(Manifest, TellsOnlyWhatDiffersFromTheServersDefaults) {
  MatchOptions options;
  ASSERT_TRUE(apply_setting(options, "server::half_time=10"));
  const auto manifest = nlohmann::json::parse(manifest_json(options, {"l", "r"}, 7));
  EXPECT_EQ(manifest["seed"], 7);
  const nlohmann::json expected = {{"server::half_time", 10},
                                   {"server::nr_extra_halfs", 0},
                                   {"server::penalty_shoot_outs", false}};
  EXPECT_EQ(manifest["settings"], expected);
}

TEST(MatchOptions, SettingsAndContradictionsAreTold) {
  MatchOptions options;
  EXPECT_EQ(apply_setting(options, "half_time=10").error().message,
            "'half_time=10' is not of the form server::NAME=VALUE");
  EXPECT_EQ(apply_setting(options, "sever::half_time=10").error().message,
            "'sever::half_time=10': the module is server or player, not 'sever'");
  EXPECT_EQ(apply_setting(options, "player::pt_mx=2").error().message,
            "unknown parameter 'pt_mx'; did you mean 'pt_max'?");
  EXPECT_TRUE(mistakes_in(options).empty());
  options.protocol = 13;
  options.cycles = 0;
  EXPECT_EQ(mistakes_in(options).size(), 2u);
}

TEST(EventLog, NumbersItsLines) {
  base::StringSink sink;
  EventLog log(sink);
  log.add(0, "started", {{"seed", 7}});
  log.add(12, "goal", {{"side", "left"}});
  EXPECT_EQ(
      sink.bytes(),
      "{\"schema\":\"cls.events/1\",\"seq\":0,\"t\":0,\"type\":\"started\",\"seed\":7}\n"
      "{\"schema\":\"cls.events/1\",\"seq\":1,\"t\":12,\"type\":\"goal\",\"side\":\"left\"}\n");
}

TEST(WholeFile, NamesWhatCannotBeWritten) {
  tests::TemporaryFolder folder;
  EXPECT_TRUE(base::write_file(folder.path() / "a.json", "{}"));
  EXPECT_EQ(tests::read_file(folder.path() / "a.json"), "{}");
  const auto refused = base::write_file(folder.path() / "none" / "a.json", "{}");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("No such file or directory"), std::string::npos);
}

}  // namespace
}  // namespace cls::orchestration::match
