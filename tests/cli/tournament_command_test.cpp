// End-to-end tests of `cls tournament` and `cls init`: short matches of mocks in processes.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tournament_outcome.h"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using cls::tests::cls_binary;
using cls::tests::Command;
using cls::tests::CommandResult;
using nlohmann::json;
using Arguments = std::vector<std::string>;

class Tournament : public testing::Test {
 protected:
  // A folder with a cls.toml: three teams, short matches.
  void SetUp() override { write_config("rounds = 1\n"); }

  void write_config(const std::string& tournament) const {
    std::ofstream(cup() / "cls.toml") << "[tournament]\ncycles = 40\n"
                                      << tournament
                                      << "[server]\nkick_off_wait = 2\n"
                                         "[teams.RED]\nendpoint = \"mock\"\n"
                                         "[teams.BLUE]\nendpoint = \"mock\"\n"
                                         "[teams.HOLD]\nendpoint = \"mock:hold\"\n";
  }

  static Arguments argv(Arguments arguments) {
    arguments.insert(arguments.begin(), {cls_binary(), "tournament"});
    return arguments;
  }
  CommandResult tournament(Arguments arguments) const { return cls::tests::run(argv(arguments)); }

  json report() const { return json::parse(tournament({"report", cup(), "--format", "json"}).out); }

  fs::path cup() const { return folder_.path(); }

  cls::tests::TemporaryFolder folder_;
};

TEST_F(Tournament, PlaysAndReports) {
  const CommandResult played = tournament({"run", cup()});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err, "");
  EXPECT_NE(played.out.find("6 of 6 matches done"), std::string::npos) << played.out;
  const json document = report();
  EXPECT_EQ(document["schema"], "cls.tournament/1");
  EXPECT_TRUE(document["complete"]);
  ASSERT_EQ(document["matches"].size(), 6u);
  for (const json& match : document["matches"]) {
    EXPECT_EQ(match["end_reason"], "finished");
    EXPECT_EQ(match["cycles"], 40);
    EXPECT_EQ(match["score"].size(), 2u);
    EXPECT_GT(match["left_figures"]["decisions"], 400);
    EXPECT_TRUE(fs::exists(cup() / match["folder"].get<std::string>() / "match.rcg"));
    EXPECT_NE(match["command"].get<std::string>().find("--seed " +
                                                       std::to_string(match["seed"].get<int>())),
              std::string::npos);
  }
  EXPECT_EQ(document["standings"].size(), 3u);
  EXPECT_EQ(document["standings"][0]["played"], 4);
  const json status = json::parse(tournament({"status", cup(), "--json"}).out);
  EXPECT_EQ(status["finished"], 6);
  EXPECT_TRUE(status["complete"]);
}

TEST_F(Tournament, PlanListsFixtures) {
  const CommandResult listed = tournament({"plan", cup(), "--rounds", "2", "--json"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  const json document = json::parse(listed.out);
  EXPECT_EQ(document["matches"].size(), 12u);
  EXPECT_EQ(document["matches"][0]["left"], document["matches"][1]["right"]);
  EXPECT_FALSE(fs::exists(cup() / "tournament.db"));
  const CommandResult text = tournament({"plan", cup()});
  EXPECT_NE(text.out.find("round-robin, 3 teams, seed 1: 6 matches\n"), std::string::npos);
}

TEST_F(Tournament, RejectsDifferentPlanWithoutForce) {
  write_config("format = \"gauntlet\"\ngauntlet = [\"RED\"]\n");
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  const CommandResult refused = tournament({"run", cup(), "--rounds", "2"});
  EXPECT_EQ(refused.exit_code, 78);
  EXPECT_NE(refused.err.find("holds another plan: rounds is 2, was not set"), std::string::npos)
      << refused.err;
  EXPECT_EQ(tournament({"run", cup(), "--concurrency", "1"}).exit_code, 0)
      << "not part of the plan";
  const CommandResult forced = tournament({"run", cup(), "--cycles", "30", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_EQ(report()["matches"][0]["cycles"], 30);
  fs::path old = cup();
  old += ".old";
  EXPECT_TRUE(fs::exists(old / "tournament.db"));
  fs::remove_all(old);
}

TEST_F(Tournament, ReportsErrorsWithLocation) {
  write_config("ronds = 3\n");
  const CommandResult unknown = tournament({"plan", cup()});
  EXPECT_EQ(unknown.exit_code, 78);
  EXPECT_NE(unknown.err.find("cls.toml:3: unknown key 'ronds'; did you mean 'rounds'?"),
            std::string::npos)
      << unknown.err;
  write_config("");
  EXPECT_EQ(tournament({"run", cup(), "--rounds", "x"}).exit_code, 2);
  EXPECT_EQ(tournament({"run", cup(), "--ronds", "1"}).exit_code, 2);
  EXPECT_EQ(tournament({"run", cup(), "--config", "none.toml"}).exit_code, 66);
  EXPECT_EQ(tournament({"status", cup() / "none"}).exit_code, 66);
  EXPECT_EQ(tournament({"report", cup(), "--format", "jsn"}).exit_code, 2);
  EXPECT_EQ(tournament({"rn", cup()}).exit_code, 2);
}

TEST_F(Tournament, RunCollectsResultOfWork) {
  const CommandResult worked = tournament({"work", cup(), "--index", "4"});
  EXPECT_EQ(worked.exit_code, 0) << worked.err;
  const fs::path result = cup() / "results" / "000004.1.json";
  ASSERT_TRUE(fs::exists(result));
  const auto written = fs::last_write_time(result);
  EXPECT_EQ(tournament({"work", cup(), "--index", "4"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(result), written) << "it is not repeated";
  EXPECT_EQ(json::parse(tournament({"status", cup(), "--json"}).out)["finished"], 1);
  EXPECT_EQ(tournament({"work", cup(), "--index", "7"}).exit_code, 66);
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  const json document = report();
  EXPECT_EQ(document["matches"][3]["ended"], json::parse(cls::tests::read_file(result))["ended"]);
  EXPECT_EQ(document["counts"]["finished"], 6);
}

TEST_F(Tournament, StopsOnFaultUnlessConfiguredOtherwise) {
  std::ofstream(cup() / "cls.toml", std::ios::app)
      << "[teams.GONE]\nendpoint = \"run:exit 3 # {port}\"\n";
  const Arguments fast = {"--format", "gauntlet", "--gauntlet", "GONE"};
  Arguments arguments = {"run", cup()};
  arguments.insert(arguments.end(), fast.begin(), fast.end());
  const CommandResult stopped = tournament(arguments);
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_NE(stopped.err.find("is invalid (refused): GONE (run:exit 3 # {port})"), std::string::npos)
      << stopped.err;
  arguments.insert(arguments.end(), {"--on-crash", "forfeit", "--keep-logs", "failed"});
  const CommandResult forfeited = tournament(arguments);
  EXPECT_EQ(forfeited.exit_code, 0) << forfeited.err;
  const json document = report();
  EXPECT_EQ(document["counts"]["forfeits"], 6);
  EXPECT_EQ(document["standings"][3]["team"], "GONE");
  EXPECT_EQ(document["standings"][3]["goals_against"], 18);
}

TEST_F(Tournament, HooksReceiveJsonOnStdin) {
  const fs::path lines_file = cup() / "hooks.jsonl";
  const fs::path final_file = cup() / "final.json";
  const CommandResult played = tournament({"run", cup(), "--keep-logs", "none", "--on-match-finish",
                                           "cat >>'" + lines_file.string() + "'", "--on-finish",
                                           "cat >'" + final_file.string() + "'; exit 3"});
  EXPECT_EQ(played.exit_code, 0);
  EXPECT_EQ(played.err, "cls: on_finish: exit code 3\n");
  std::ifstream lines(lines_file);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_EQ(json::parse(line)["end_reason"], "finished");
  }
  EXPECT_EQ(count, 6);
  EXPECT_EQ(json::parse(cls::tests::read_file(final_file))["schema"], "cls.tournament/1");
  EXPECT_TRUE(fs::is_empty(cup() / "matches")) << "--keep-logs none";
}

TEST_F(Tournament, ResumesAfterSigterm) {
  write_config("rounds = 3\n");
  Command playing(argv({"run", cup(), "--concurrency", "1"}));
  while (!fs::exists(cup() / "matches")) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(1s);
  playing.send_signal(SIGTERM);
  const CommandResult ended = playing.finish(5s);
  EXPECT_EQ(ended.exit_code, 143) << ended.err;
  EXPECT_NE(ended.err.find("run the same command to resume"), std::string::npos) << ended.err;
  const CommandResult on = tournament({"run", cup()});
  EXPECT_EQ(on.exit_code, 0) << on.err;
  EXPECT_EQ(report()["counts"]["finished"], 18);
}

TEST_F(Tournament, StopFinishesCurrentMatches) {
  write_config("rounds = 20\n");
  EXPECT_EQ(tournament({"stop", cup()}).exit_code, 66);
  Command playing(argv({"run", cup()}));
  while (!fs::exists(cup() / "matches")) std::this_thread::sleep_for(10ms);
  const CommandResult second = tournament({"run", cup()});
  EXPECT_EQ(second.exit_code, 75) << second.err;
  EXPECT_EQ(tournament({"stop", cup()}).exit_code, 0);
  const CommandResult ended = playing.finish(10s);
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  const json document = report();
  EXPECT_GT(document["counts"]["finished"], 0);
  EXPECT_GT(document["counts"]["open"], 0);
  EXPECT_FALSE(fs::exists(cup() / "stop"));
}

// Killed at random times; CLS_FULL runs all 20.
TEST_F(Tournament, SigkillLosesOnlyCurrentMatches) {
  const int kills = std::getenv("CLS_FULL") != nullptr ? 20 : 3;
  write_config("rounds = 3\n");
  const std::string mark = cls::tests::new_mark();
  const Arguments environment = {std::string(cls::tests::kMarkVariable) + "=" + mark};
  std::uint32_t random = 12345;
  std::map<int, std::string> finished;
  for (int kill = 0; kill < kills; ++kill) {
    Command playing(argv({"run", cup()}), environment);
    random = random * 1664525u + 1013904223u;
    std::this_thread::sleep_for(std::chrono::milliseconds(50 + random / 4294968));
    playing.send_signal(SIGKILL);
    playing.finish();
    EXPECT_TRUE(cls::tests::all_marked_gone(mark, 3s)) << "no process survives";
    if (!fs::exists(cup() / "tournament.db")) continue;
    for (const json& match : report()["matches"]) {
      if (match["end_reason"].is_null()) continue;
      const int index = match["index"];
      const std::string once = match["ended"].get<std::string>() + match["folder"].dump();
      EXPECT_EQ(finished.emplace(index, once).first->second, once) << "played twice";
    }
  }
  const CommandResult last = tournament({"run", cup()});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  const json broken = report();
  for (const auto& [index, once] : finished) {
    const json& match = broken["matches"][static_cast<std::size_t>(index) - 1];
    EXPECT_EQ(once, match["ended"].get<std::string>() + match["folder"].dump());
  }
  cls::tests::TemporaryFolder other;
  fs::copy_file(cup() / "cls.toml", other.path() / "cls.toml");
  const CommandResult unbroken = tournament({"run", other.path(), "--json"});
  ASSERT_EQ(unbroken.exit_code, 0) << unbroken.err;
  EXPECT_EQ(cls::tests::outcome_of(broken), cls::tests::outcome_of(json::parse(unbroken.out)));
}

TEST_F(Tournament, MatchAcceptsTeamNamesAsSides) {
  const Arguments base = {cls_binary(), "match", "--config", cup() / "cls.toml",        "--json",
                          "--cycles",   "20",    "--set",    "server::kick_off_wait=2", "--dir",
                          cup() / "m"};
  const auto match = [&](const std::string& left, const std::string& right) {
    Arguments arguments = base;
    arguments.insert(arguments.begin() + 2, {left, right});
    return cls::tests::run(arguments);
  };
  const CommandResult played = match("RED", "HOLD");
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const json result = json::parse(played.out);
  EXPECT_EQ(result["left"]["name"], "RED");
  EXPECT_EQ(result["right"]["name"], "HOLD");
  EXPECT_EQ(result["right"]["endpoint"], "mock:hold");
  const CommandResult unknown = match("RAD", "HOLD");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("unknown side 'RAD'; did you mean 'RED'?"), std::string::npos);
  EXPECT_EQ(match("moc", "HOLD").exit_code, 2);
  write_config("ronds = 1\n");
  EXPECT_EQ(match("RED", "HOLD").exit_code, 78);
}

TEST_F(Tournament, ReportsInSixFormats) {
  ASSERT_EQ(tournament({"run", cup(), "--keep-logs", "none"}).exit_code, 0);
  const auto report_as = [&](const std::string& format) {
    const CommandResult written = tournament({"report", cup(), "--format", format});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    return written.out;
  };
  const std::string csv = report_as("csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  EXPECT_EQ(csv.rfind("index,round,stage,pairing,left,right,seed,end_reason", 0), 0u);
  for (std::size_t at = 0, end = 0; end != std::string::npos && at < csv.size(); at = end + 1) {
    end = csv.find('\n', at);
    const std::string line = csv.substr(at, end - at);
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 23) << line;
  }
  const std::string junit = report_as("junit");
  EXPECT_NE(junit.find("tests=\"6\" failures=\"0\" errors=\"0\" time="), std::string::npos);
  EXPECT_NE(report_as("md").find("| # | team | played |"), std::string::npos);
  EXPECT_EQ(report_as("html").rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_NE(report_as("text").find("won-drawn-lost, row against column"), std::string::npos);
  const fs::path file = cup() / "report.md";
  EXPECT_EQ(tournament({"report", cup(), "--format", "md", "--out", file}).out, "");
  EXPECT_EQ(cls::tests::read_file(file), report_as("md"));
}

TEST_F(Tournament, JUnitNamesSideAtFault) {
  std::ofstream(cup() / "cls.toml", std::ios::app)
      << "[teams.GONE]\nendpoint = \"run:exit 3 # {port}\"\n";
  ASSERT_EQ(tournament({"run", cup(), "--on-crash", "rerun", "--max-reruns", "0"}).exit_code, 1);
  const std::string junit = tournament({"report", cup(), "--format", "junit"}).out;
  EXPECT_NE(junit.find("tests=\"12\" failures=\"6\" errors=\"0\""), std::string::npos) << junit;
  EXPECT_NE(junit.find("<failure type=\"refused\" message=\"GONE (run:exit 3 # {port})"),
            std::string::npos);
  const fs::path file = cup() / "junit.xml";
  std::ofstream(file) << junit;
  if (cls::tests::run({"/bin/sh", "-c", "command -v xmllint"}).exit_code != 0) {
    GTEST_SKIP() << "no xmllint (package libxml2-utils)";
  }
  const CommandResult valid = cls::tests::run(
      {"xmllint", "--noout", "--schema", cls::tests::fixture("junit/junit.xsd"), file});
  EXPECT_EQ(valid.exit_code, 0) << valid.err;
}

TEST_F(Tournament, CompareStopsWhenDecided) {
  // No goals in so few cycles: a large difference is soon ruled out.
  const Arguments base = {
      cls_binary(), "compare",   "RED",    "HOLD", "--config", cup() / "cls.toml",
      "--dir",      cup() / "c", "--elo1", "400",  "--json"};
  const CommandResult compared = cls::tests::run(base);
  EXPECT_EQ(compared.exit_code, 1) << compared.err;
  const json document = json::parse(compared.out);
  EXPECT_EQ(document["schema"], "cls.compare/1");
  EXPECT_EQ(document["verdict"], "not better");
  EXPECT_EQ(document["new"], "RED");
  EXPECT_LE(document["llr"], document["lower"]);
  EXPECT_NE(document["model"].get<std::string>().find("pentanomial SPRT"), std::string::npos);
  const auto played = document["matches"].size();
  EXPECT_LT(played, 40u);
  const CommandResult again = cls::tests::run(base);
  EXPECT_EQ(json::parse(again.out)["matches"].size(), played) << "already decided";
  Arguments undecided = base;
  undecided[7] = (cup() / "d").string();
  undecided.insert(undecided.end(), {"--opponents", "BLUE", "--max-pairs", "1"});
  const CommandResult open = cls::tests::run(undecided);
  EXPECT_EQ(open.exit_code, 1) << open.err;
  EXPECT_EQ(json::parse(open.out)["verdict"], "undecided");
  EXPECT_EQ(json::parse(open.out)["matches"].size(), 4u);
  for (const Arguments& error :
       {Arguments{"--elo0", "50", "--elo1", "10"}, Arguments{"--alpha", "0.7"},
        Arguments{"--opponents", "RED"}, Arguments{"--elo2", "1"}}) {
    Arguments arguments = base;
    arguments.insert(arguments.end(), error.begin(), error.end());
    EXPECT_EQ(cls::tests::run(arguments).exit_code, 2) << error[0];
  }
}

TEST(Init, WritesPlayableConfigAndOverwritesNone) {
  cls::tests::TemporaryFolder folder;
  const fs::path cup = folder.path() / "cup";
  const CommandResult made = cls::tests::run({cls_binary(), "init", cup});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out, (cup / "cls.toml").string() + "\n");
  const CommandResult listed = cls::tests::run({cls_binary(), "tournament", "plan", cup});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  const CommandResult again = cls::tests::run({cls_binary(), "init", cup});
  EXPECT_EQ(again.exit_code, 73);
  EXPECT_NE(again.err.find("exists; use --force to replace it"), std::string::npos);
}

}  // namespace
