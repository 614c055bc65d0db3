// End-to-end tests of `cls tournament` and `cls init`: short matches of mocks in processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tournament_outcome.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;
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
  CommandResult tournament(Arguments arguments) const { return run(argv(arguments)); }

  json report() const { return json::parse(tournament({"report", cup(), "--format", "json"}).out); }

  fs::path cup() const { return folder_.path(); }

  TemporaryFolder folder_;
};

TEST_F(Tournament, PlaysAndReports) {
  const CommandResult played = tournament({"run", cup()});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err.rfind("cls: 6 matches to play\n", 0), 0u) << played.err;
  for (int match = 1; match <= 6; ++match) {
    EXPECT_THAT(played.err, HasSubstr("match " + std::to_string(match) + "/6  "));
  }

  EXPECT_THAT(played.err, HasSubstr("  RED 0:0 HOLD  (finished, "));
  EXPECT_EQ(tournament({"run", cup(), "--quiet"}).err, "");
  EXPECT_THAT(played.out, HasSubstr("6 of 6 matches done"));

  // What is longest scrolls away: standings and winner are last, and how to see a match.
  const std::size_t standings = played.out.find("\nstandings\n");
  EXPECT_NE(standings, std::string::npos) << played.out;
  EXPECT_GT(standings, played.out.find("\nmatches\n")) << played.out;
  EXPECT_THAT(played.out,
              testing::ContainsRegex("\n(winner|level): [A-Z]+.*, [0-9]+ points?, goals "
                                     "[0-9]+:[0-9]+\n  cls watch [^\n]+\n$"));
  const json document = report();
  EXPECT_EQ(document["schema"], "cls.tournament/1");
  EXPECT_EQ(document["complete"], true);
  ASSERT_EQ(document["matches"].size(), 6u);

  for (const json& match : document["matches"]) {
    EXPECT_EQ(match["end_reason"], "finished");
    EXPECT_EQ(match["cycles"], 40);
    EXPECT_EQ(match["score"].size(), 2u);
    EXPECT_GT(match["left_figures"]["decisions"], 400);
    EXPECT_TRUE(fs::exists(cup() / match["folder"].get<std::string>() / "match.rcg.gz"));
    EXPECT_THAT(match["command"].get<std::string>(),
                HasSubstr("--seed " + std::to_string(match["seed"].get<int>())));
  }

  EXPECT_EQ(document["standings"].size(), 3u);
  EXPECT_EQ(document["standings"][0]["played"], 4);
  const json status = json::parse(tournament({"status", cup(), "--json"}).out);
  EXPECT_EQ(status["finished"], 6);
  EXPECT_EQ(status["complete"], true);
}

TEST_F(Tournament, PlanListsFixtures) {
  const CommandResult listed = tournament({"plan", cup(), "--rounds", "2", "--json"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  const json document = json::parse(listed.out);
  EXPECT_EQ(document["matches"].size(), 12u);
  EXPECT_EQ(document["matches"][0]["left"], document["matches"][1]["right"]);
  EXPECT_FALSE(fs::exists(cup() / "tournament.db"));
  const CommandResult text = tournament({"plan", cup()});
  EXPECT_THAT(text.out, HasSubstr("round-robin, 3 teams, seed 1: 6 matches\n"));
}

TEST_F(Tournament, RejectsDifferentPlanWithoutForce) {
  write_config("format = \"gauntlet\"\ngauntlet = [\"RED\"]\n");
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  EXPECT_THAT(tournament({"run", cup(), "--rounds", "2"}),
              Exits(78, HasSubstr("holds another plan: rounds is 2, was not set")));
  EXPECT_EQ(tournament({"run", cup(), "--concurrency", "1"}).exit_code, 0)
      << "not part of the plan";
  const CommandResult forced = tournament({"run", cup(), "--cycles", "30", "--force"});
  EXPECT_THAT(forced.err, HasSubstr("cls: old tournament moved to "));
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_EQ(report()["matches"][0]["cycles"], 30);
  fs::path old = cup();
  old += ".old";
  EXPECT_TRUE(fs::exists(old / "tournament.db"));
  fs::remove_all(old);
}

TEST_F(Tournament, ForceRenamesNothingBeforeTeamsAreChecked) {
  write_config("format = \"gauntlet\"\ngauntlet = [\"RED\"]\n");
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  const std::string plan = read_file(cup() / "plan.toml");
  EXPECT_THAT(tournament({"run", cup(), "--force", "--server", "cls_no_such_server"}),
              Exits(66, Not(HasSubstr("moved to"))));
  EXPECT_EQ(read_file(cup() / "plan.toml"), plan);
  EXPECT_TRUE(fs::exists(cup() / "tournament.db"));
}

TEST_F(Tournament, ReportsErrorsWithLocation) {
  write_config("ronds = 3\n");
  const CommandResult unknown = tournament({"plan", cup()});
  EXPECT_EQ(unknown.exit_code, 78);
  EXPECT_THAT(unknown.err, HasSubstr("cls.toml:3: unknown key 'ronds'; did you mean 'rounds'?"));
  write_config("");
  EXPECT_EQ(tournament({"run", cup(), "--rounds", "x"}).exit_code, 2);
  EXPECT_EQ(tournament({"run", cup(), "--ronds", "1"}).exit_code, 2);
  EXPECT_EQ(tournament({"run", cup(), "--config", "none.toml"}).exit_code, 66);
  EXPECT_EQ(tournament({"status", cup() / "none"}).exit_code, 66);
  EXPECT_EQ(tournament({"report", cup(), "--format", "jsn"}).exit_code, 2);
  EXPECT_EQ(tournament({"rn", cup()}).exit_code, 2);
}

TEST_F(Tournament, RunCollectsResultOfWork) {
  EXPECT_THAT(tournament({"work", cup(), "--index", "4"}), Exits(0));
  const fs::path result = cup() / "results" / "000004.1.json";
  ASSERT_TRUE(fs::exists(result));
  const auto written = fs::last_write_time(result);
  EXPECT_EQ(tournament({"work", cup(), "--index", "4"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(result), written) << "it is not repeated";
  EXPECT_EQ(json::parse(tournament({"status", cup(), "--json"}).out)["finished"], 1);
  EXPECT_EQ(tournament({"work", cup(), "--index", "7"}).exit_code, 66);
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  const json document = report();
  EXPECT_EQ(document["matches"][3]["ended"], json::parse(read_file(result))["ended"]);
  EXPECT_EQ(document["counts"]["finished"], 6);
}

TEST_F(Tournament, StopsOnFaultUnlessConfiguredOtherwise) {
  std::ofstream(cup() / "cls.toml", std::ios::app)
      << "[teams.GONE]\nendpoint = \"run:exit 3 # {port}\"\n";
  const Arguments fast = {"--format", "gauntlet", "--gauntlet", "GONE"};
  Arguments arguments = joined({"run", cup()}, fast);
  const CommandResult stopped = tournament(arguments);
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_THAT(stopped.err, HasSubstr("is invalid (refused): GONE (run:exit 3 # {port})"));

  const std::size_t counts = stopped.out.find(" of 6 matches done");
  ASSERT_NE(counts, std::string::npos) << stopped.out;
  EXPECT_THAT(stopped.err,
              HasSubstr("cls: " + stopped.out.substr(counts - 1,
                                                     stopped.out.find('\n', counts) - counts + 1)))
      << "stderr and report agree: " << stopped.out;

  arguments.insert(arguments.end(), {"--on-crash", "forfeit", "--keep-logs", "failed"});
  EXPECT_THAT(tournament(arguments), Exits(0));
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
                                           "pwd >&2; cat >'" + final_file.string() + "'; exit 3"});
  EXPECT_EQ(played.exit_code, 0);
  EXPECT_THAT(played.err,
              HasSubstr("cls: on_finish: exit code 3: " + fs::canonical(cup()).string() + "\n"))
      << "hooks run where cls.toml is: ";

  std::ifstream lines(lines_file);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_EQ(json::parse(line)["end_reason"], "finished");
  }

  EXPECT_EQ(count, 6);
  EXPECT_EQ(json::parse(read_file(final_file))["schema"], "cls.tournament/1");
  EXPECT_TRUE(fs::is_empty(cup() / "matches")) << "--keep-logs none";
}

TEST_F(Tournament, EndsWhatHooksLeaveBehind) {
  Command playing(argv({"run", cup(), "--keep-logs", "none", "--on-match-finish", "sleep 300 &"}));
  EXPECT_THAT(playing.finish(50s),
              Exits(0, HasSubstr("on_match_finish: ended a process that it had left behind")));
}

TEST_F(Tournament, SignalEndsHooksThatHang) {
  Command playing(argv({"run", cup(), "--keep-logs", "none", "--on-finish",
                        "trap '' TERM; echo waiting >&2; sleep 300"}));
  ASSERT_TRUE(playing.wait_for_errors("match 6/6  "));
  std::this_thread::sleep_for(1s);
  playing.send_signal(SIGTERM);
  const CommandResult ended = playing.finish(20s);
  EXPECT_THAT(ended.err, HasSubstr("on_finish: ended, because it still ran"));
}

TEST_F(Tournament, ResumesAfterSigterm) {
  write_config("rounds = 3\n");
  Command playing(argv({"run", cup(), "--concurrency", "1"}));
  ASSERT_TRUE(playing.wait_for_errors("match 1/18  "));
  playing.send_signal(SIGTERM);
  EXPECT_THAT(playing.finish(5s),
              Exits(143, HasSubstr("cls: resume: " + cls_binary().string() + " tournament run " +
                                   cup().string() + " --concurrency 1\n")));
  EXPECT_THAT(tournament({"run", cup()}), Exits(0));
  EXPECT_EQ(report()["counts"]["finished"], 18);
}

TEST_F(Tournament, StopFinishesCurrentMatches) {
  write_config("rounds = 20\n");
  EXPECT_EQ(tournament({"stop", cup()}).exit_code, 66);
  Command playing(argv({"run", cup()}));
  while (!fs::exists(cup() / "matches")) std::this_thread::sleep_for(10ms);
  EXPECT_THAT(tournament({"run", cup()}), Exits(75));
  EXPECT_EQ(tournament({"stop", cup()}).exit_code, 0);
  EXPECT_THAT(playing.finish(10s), Exits(130));
  const json document = report();
  EXPECT_GT(document["counts"]["finished"], 0);
  EXPECT_GT(document["counts"]["open"], 0);
  EXPECT_FALSE(fs::exists(cup() / "stop"));
}

// Killed at random times; CLS_FULL runs all 20.
TEST_F(Tournament, SigkillLosesOnlyCurrentMatches) {
  const int kills = std::getenv("CLS_FULL") != nullptr ? 20 : 3;
  write_config("rounds = 3\n");
  const std::string mark = new_mark();
  const Arguments environment = {std::string(kMarkVariable) + "=" + mark};
  std::uint32_t random = 12345;
  std::map<int, std::string> finished;
  for (int kill = 0; kill < kills; ++kill) {
    Command playing(argv({"run", cup()}), environment);
    random = random * 1664525u + 1013904223u;
    std::this_thread::sleep_for(std::chrono::milliseconds(50 + random / 4294968));
    playing.send_signal(SIGKILL);
    playing.finish();
    EXPECT_TRUE(all_marked_gone(mark, 3s)) << "no process survives";
    if (!fs::exists(cup() / "tournament.db")) continue;
    const json reported = report();
    for (const json& match : reported["matches"]) {
      if (match["end_reason"].is_null()) continue;
      const auto index = match["index"].get<int>();
      const std::string once = match["ended"].get<std::string>() + match["folder"].dump();
      EXPECT_EQ(finished.emplace(index, once).first->second, once) << "played twice";
    }
  }

  EXPECT_THAT(tournament({"run", cup()}), Exits(0));
  const json broken = report();
  for (const auto& [index, once] : finished) {
    const json& match = broken["matches"][static_cast<std::size_t>(index) - 1];
    EXPECT_EQ(once, match["ended"].get<std::string>() + match["folder"].dump());
  }

  TemporaryFolder other;
  fs::copy_file(cup() / "cls.toml", other.path() / "cls.toml");
  const CommandResult unbroken = tournament({"run", other.path(), "--json"});

  ASSERT_EQ(unbroken.exit_code, 0) << unbroken.err;
  EXPECT_EQ(outcome_of(broken), outcome_of(json::parse(unbroken.out)));
}

TEST_F(Tournament, MatchAcceptsTeamNamesAsSides) {
  const Arguments base = {cls_binary(), "match", "--config", cup() / "cls.toml",        "--json",
                          "--cycles",   "20",    "--set",    "server::kick_off_wait=2", "--dir",
                          cup() / "m"};
  const auto match = [&](const std::string& left, const std::string& right) {
    Arguments arguments = base;
    arguments.insert(arguments.begin() + 2, {left, right});
    return run(arguments);
  };
  const CommandResult played = match("RED", "HOLD");
  ASSERT_EQ(played.exit_code, 0) << played.err;

  const json result = json::parse(played.out);
  EXPECT_EQ(result["left"]["name"], "RED");
  EXPECT_EQ(result["right"]["name"], "HOLD");
  EXPECT_EQ(result["right"]["endpoint"], "mock:hold");

  const CommandResult unknown = match("RAD", "HOLD");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown side 'RAD'; did you mean 'RED'?"));
  EXPECT_EQ(match("moc", "HOLD").exit_code, 2);
  EXPECT_THAT(match("NEWEST", "HOLD"),
              Exits(2, HasSubstr("cls.toml are RED, BLUE, HOLD; other sides: cls match --help\n")));

  write_config("ronds = 1\n");
  EXPECT_EQ(match("RED", "HOLD").exit_code, 78);
}

TEST_F(Tournament, ReportsWithChosenNameColumnsAndMatches) {
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  EXPECT_THAT(tournament({"report", cup(), "--columns", "team,pionts"}),
              Exits(2, "cls: --columns: 'pionts': did you mean 'points'?\n"));
  const std::string chosen = tournament({"report", cup(), "--columns", "team,points"}).out;
  EXPECT_THAT(chosen, HasSubstr("\nstandings\n  team  pts\n"));

  // Name and columns may change after the matches.
  write_config("rounds = 1\nname = \"Spring cup\"\ncolumns = [\"rank\", \"team\"]\n");
  const std::string renamed = tournament({"report", cup()}).out;
  EXPECT_EQ(renamed.rfind("Spring cup: round-robin of 3 teams, ", 0), 0u) << renamed;
  EXPECT_THAT(renamed, HasSubstr("\nstandings\n  #  team\n"));

  const std::string status = tournament({"status", cup(), "--columns", "team"}).out;
  EXPECT_EQ(status.rfind("6 of 6 matches done; complete\n\nstandings\n  team\n", 0), 0u) << status;
  const std::string all = tournament({"report", cup(), "--matches"}).out;
  for (int match = 1; match <= 6; ++match) {
    EXPECT_THAT(all, HasSubstr("\n  match " + std::to_string(match) + ", "));
  }
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.size() <= 80 || line.find("    logs: ") == 0 || line.find('/') < 20) << line;
  }
}

TEST_F(Tournament, LinksFromTheReportFileToTheFoldersOfMatches) {
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  fs::create_directories(cup() / "web");
  const auto link_in = [this](const fs::path& file) {
    EXPECT_EQ(tournament({"report", cup(), "--format", "html", "--out", file}).exit_code, 0);
    const std::string html = read_file(file);
    const std::size_t at = html.find("<a href=\"") + 9;
    return file.parent_path() / html.substr(at, html.find('"', at) - at);
  };
  for (const fs::path& file : {cup() / "report.html", cup() / "web" / "report.html"}) {
    const fs::path folder = link_in(file);
    EXPECT_TRUE(fs::is_regular_file(folder / "result.json")) << folder;
    EXPECT_TRUE(folder.string().starts_with(cup().string()));
  }
}

TEST_F(Tournament, WritesReplayPagesOfItsMatches) {
  ASSERT_EQ(tournament({"run", cup()}).exit_code, 0);
  const std::string file = cup() / "report.html";
  EXPECT_EQ(tournament({"report", cup(), "--format", "html", "--out", file}).exit_code, 0);
  EXPECT_THAT(read_file(file), Not(HasSubstr("match.html")));
  EXPECT_THAT(tournament({"report", cup(), "--format", "html", "--out", file, "--replays"}),
              Exits(0));
  const std::string html = read_file(file);
  const std::size_t end = html.find("match.html\">watch</a>");
  ASSERT_NE(end, std::string::npos);
  const std::size_t start = html.rfind("<a href=\"", end) + 9;
  const fs::path page = cup() / html.substr(start, end - start) / "match.html";
  EXPECT_TRUE(read_file(page).starts_with("<!doctype html>")) << page;
}

TEST_F(Tournament, ReportsInSixFormats) {
  ASSERT_EQ(tournament({"run", cup(), "--keep-logs", "none"}).exit_code, 0);
  const auto report_as = [&](const std::string& format) {
    const CommandResult written = tournament({"report", cup(), "--format", format});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    return written.out;
  };
  const std::string csv = report_as("csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 7);
  EXPECT_EQ(csv.rfind("index,round,stage,pairing,left,right,seed,end_reason", 0), 0u);

  for (std::size_t at = 0, end = 0; end != std::string::npos && at < csv.size(); at = end + 1) {
    end = csv.find('\n', at);
    const std::string line = csv.substr(at, end - at);
    EXPECT_EQ(std::ranges::count(line, ','), 27) << line;
  }

  const std::string junit = report_as("junit");
  EXPECT_THAT(junit, HasSubstr("tests=\"6\" failures=\"0\" errors=\"0\" time="));
  EXPECT_THAT(report_as("md"), HasSubstr("| # | team | played |"));
  EXPECT_EQ(report_as("html").rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_THAT(report_as("text"), HasSubstr("won-drawn-lost, row against column"));

  const fs::path file = cup() / "report.md";
  EXPECT_EQ(tournament({"report", cup(), "--format", "md", "--out", file}).out, "");
  EXPECT_EQ(read_file(file), report_as("md"));
}

TEST_F(Tournament, JUnitNamesSideAtFault) {
  std::ofstream(cup() / "cls.toml", std::ios::app)
      << "[teams.GONE]\nendpoint = \"run:exit 3 # {port}\"\n";
  ASSERT_EQ(tournament({"run", cup(), "--on-crash", "rerun", "--max-reruns", "0"}).exit_code, 1);
  const std::string junit = tournament({"report", cup(), "--format", "junit"}).out;
  EXPECT_THAT(junit, HasSubstr("tests=\"12\" failures=\"6\" errors=\"0\""));
  EXPECT_THAT(junit, HasSubstr("<failure type=\"refused\" message=\"GONE (run:exit 3 # {port})"));
  const fs::path file = cup() / "junit.xml";
  std::ofstream(file) << junit;
  if (run({"/bin/sh", "-c", "command -v xmllint"}).exit_code != 0) {
    GTEST_SKIP() << "no xmllint (package libxml2-utils)";
  }
  EXPECT_THAT(run({"xmllint", "--noout", "--schema", fixture("junit/junit.xsd"), file}), Exits(0));
}

TEST_F(Tournament, CompareStopsWhenDecided) {
  // No goals in so few cycles: a large difference is soon ruled out.
  const Arguments base = {cls_binary(),       "compare", "RED",       "HOLD",   "--config",
                          cup() / "cls.toml", "--dir",   cup() / "c", "--elo1", "400",
                          "--json",           "--test",  "sprt"};
  const CommandResult compared = run(base);
  EXPECT_EQ(compared.exit_code, 1) << compared.err;
  const json document = json::parse(compared.out);
  EXPECT_EQ(document["schema"], "cls.compare/1");
  EXPECT_EQ(document["verdict"], "not better");
  EXPECT_EQ(document["new"], "RED");
  EXPECT_LE(document["llr"], document["lower"]);
  EXPECT_THAT(document["model"].get<std::string>(), HasSubstr("pentanomial SPRT"));
  EXPECT_EQ(document["test"], "sprt");

  const auto played = document["matches"].size();
  EXPECT_LT(played, 40u);

  const CommandResult again = run(base);
  EXPECT_EQ(json::parse(again.out)["matches"].size(), played) << "already decided";

  Arguments betting = base;
  betting.back() = "betting";
  const json other = json::parse(run(betting).out);
  EXPECT_EQ(other["verdict"], "not better") << "the same matches, another test";
  EXPECT_EQ(other["pairs"], 3) << "draws are soon worse than 91 % of the points";
  EXPECT_GE(other["evidence"]["not_better"], other["evidence"]["not_better_at"]);
  EXPECT_LE(other["elo_bounds"][1], 400);

  Arguments undecided = base;
  undecided[7] = (cup() / "d").string();
  undecided.insert(undecided.end(), {"--opponents", "BLUE", "--max-pairs", "1"});
  const CommandResult open = run(undecided);
  EXPECT_EQ(open.exit_code, 3) << open.err;
  EXPECT_EQ(json::parse(open.out)["verdict"], "undecided");
  EXPECT_EQ(json::parse(open.out)["matches"].size(), 4u);

  for (const Arguments& error :
       {Arguments{"--elo0", "50", "--elo1", "10"}, Arguments{"--alpha", "0.7"},
        Arguments{"--measure", "shots"}, Arguments{"--measure", "goals", "--goals1", "3"},
        Arguments{"--opponents", "RED"}, Arguments{"--elo2", "1"}}) {
    EXPECT_EQ(run(joined(base, error)).exit_code, 2) << error[0];
  }
}

TEST_F(Tournament, KeepsWarningsOfMatches) {
  std::ofstream(cup() / "drill.json")
      << R"({"otherwise": "simple", "expect": [{"rpc": "GetPlayerActions", "count": 1}]})";
  const Arguments fast = {
      "run",       cup(),      "--team", "DRILL=mock:drill.json", "--format", "list",  "--matches",
      "DRILL:RED", "--cycles", "10",     "--keep-logs",           "none",     "--json"};
  EXPECT_THAT(tournament(fast),
              Exits(0, testing::AllOf(HasSubstr(" s, 1 warning)\n"),
                                      HasSubstr("cls: warning: match 1 (DRILL - RED)"),
                                      HasSubstr("cls: 2 warnings in 2 matches\n"))));
  Arguments strict = fast;
  strict.emplace_back("--strict");
  EXPECT_THAT(tournament(strict), Exits(1, HasSubstr("cls: 2 warnings in 2 matches (--strict)\n")));
  EXPECT_EQ(report()["counts"]["finished"], 2) << "the matches stay valid";
}

TEST_F(Tournament, ChecksTeamsBeforeTheFirstMatch) {
  const Arguments gone = {"run", cup(), "--team", "GONE=unix:none.sock", "--start-timeout", "0.1"};
  const CommandResult refused = tournament(gone);
  EXPECT_EQ(refused.exit_code, 69) << refused.err;
  EXPECT_EQ(refused.err.rfind("cls: team GONE (unix:none.sock): nothing listens at ", 0), 0u)
      << refused.err;
  EXPECT_FALSE(fs::exists(cup() / "matches"));
  EXPECT_EQ(tournament({"run", cup(), "--team", "GONE=run:./none {port}"}).exit_code, 66)
      << "nothing was played yet, so another plan is accepted";
  EXPECT_THAT(tournament({"run", cup(), "--team", "GONE=run:./none {port}", "--no-preflight"}),
              Exits(1, HasSubstr("is invalid (refused)")));
}

TEST_F(Tournament, WarnsOfTooManyParallelMatches) {
  const Arguments many = {"run",      cup(),      "--format", "list",          "--matches",
                          "RED:HOLD", "--cycles", "10",       "--concurrency", "4000"};
  Arguments strict = many;
  strict.emplace_back("--strict");
  EXPECT_THAT(tournament(strict), Exits(1, HasSubstr("cls: no match was started (--strict)\n")));
  const CommandResult played = tournament(many);
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err.rfind("cls: warning: 4000 parallel matches on ", 0), 0u) << played.err;
}

TEST(Init, WritesPlayableConfigAndOverwritesNone) {
  TemporaryFolder folder;
  const fs::path cup = folder.path() / "cup";
  EXPECT_THAT(run({cls_binary(), "init", cup}),
              Prints(0, testing::Eq((cup / "cls.toml").string() + "\n")));
  EXPECT_THAT(run({cls_binary(), "tournament", "plan", cup}), Exits(0));
  // As README shows it.
  EXPECT_THAT(Command({cls_binary(), "compare", "RED", "BLUE", "--config", "cup/cls.toml",
                       "--max-pairs", "1", "--cycles", "30"},
                      {}, folder.path())
                  .finish(),
              Prints(3, HasSubstr("RED against BLUE")));
  EXPECT_THAT(run({cls_binary(), "init", cup}),
              Exits(73, HasSubstr("exists; --force renames it to cls.toml.old")));
}

TEST_F(Tournament, LeavesOutTheTeamsOfAProjectWhenItNamesItsOwn) {
  Command inside({cls_binary(), "tournament", "plan", "mini", "--team", "A=mock", "--team",
                  "B=mock:hold", "--json"},
                 {}, cup());
  ASSERT_THAT(inside.finish(30s),
              Prints(0, testing::AllOf(HasSubstr("\"A\""), Not(HasSubstr("RED")))));

  const CommandResult own = tournament({"plan", cup(), "--team", "A=mock", "--json"});
  EXPECT_THAT(own.out, HasSubstr("\"A\"")) << own.err;
  EXPECT_THAT(own.out, HasSubstr("RED")) << "the tournament's own file: added";
}

}  // namespace
}  // namespace cls::tests
