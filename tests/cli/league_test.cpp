// The organizer's commands: presets, check-in, stages, decisions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "tests/support/cls_folder.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;

class League : public testing::Test, protected ClsFolder {
 protected:
  League() : ClsFolder(std::chrono::seconds(300)) {}

  void copy_fixture(const std::string& year) const {
    std::filesystem::create_directories(path("cup"));
    for (const char* file : {"cls.toml", "results.txt"}) {
      std::filesystem::copy_file(fixture("tournament/robocup" + year) / file, path("cup") / file);
    }
  }

  json report() const { return json::parse(run({"tournament", "report", "cup", "--json"}).out); }

  std::vector<std::string> ranks() const {
    std::vector<std::string> names;
    const json document = report();
    for (const json& row : document["standings"]) names.push_back(row["team"].get<std::string>());
    return names;
  }
};

TEST_F(League, ResultsOf2025GiveItsFinalStandings) {
  copy_fixture("2025");
  const CommandResult result = run({"tournament", "run", "cup", "--results", "cup/results.txt"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(ranks(),
            (std::vector<std::string>{"HELIOS", "YuShan", "FRA-UNIted", "RoboCIn", "Oxsy", "Titas",
                                      "SRBIAU2D", "SIRLab", "RoboTech", "ITAndroids"}));
  EXPECT_NE(result.out.find("(4+2) - (4+0)"), std::string::npos) << result.out;
}

TEST_F(League, ResultsOf2024NeedADecision) {
  copy_fixture("2024");
  const std::vector<std::string> play = {"tournament", "run", "cup", "--results",
                                         "cup/results.txt"};
  const CommandResult stuck = run(play);

  EXPECT_EQ(stuck.exit_code, 65);
  EXPECT_NE(stuck.err.find("no result of CYRUS and FRA-UNIted, match 146, below [final day, "
                           "semi-final]"),
            std::string::npos)
      << stuck.err;
  EXPECT_THAT(run({"tournament", "decide", "cup", "--match", "145", "--award", "1:0", "--reason",
                   "YuShan played the semi-final"}),
              Exits(0));
  EXPECT_EQ(run(play).exit_code, 0);
  EXPECT_EQ(ranks(), (std::vector<std::string>{"HELIOS", "CYRUS", "YuShan", "FRA-UNIted", "R2D2",
                                               "RoboCIn", "Oxsy", "AETeam", "ITAndroids", "Mars"}));

  const CommandResult page = run({"tournament", "report", "cup", "--format", "html"});
  EXPECT_NE(page.out.find("YuShan played the semi-final"), std::string::npos);
}

TEST_F(League, TeamsOfAPresetCheckIn) {
  ASSERT_EQ(run({"init", "cup", "--preset", "starter"}).exit_code, 0);
  const CommandResult checked =
      run({"tournament", "check-in", "cup", "--mode", "lockstep", "--json"});
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  const json document = json::parse(checked.out);
  ASSERT_EQ(document["teams"].size(), 8u);
  for (const json& team : document["teams"]) {
    EXPECT_EQ(team["players"], 11);
    EXPECT_EQ(team["missed"], 0);
  }
}

TEST_F(League, CheckInNamesATeamThatDoesNotPlay) {
  write("cup/cls.toml",
        "[tournament]\n[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.GONE]\nendpoint = \"run:echo no such model {port}; exit 3\"\n");
  const CommandResult checked = run({"tournament", "check-in", "cup"});
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_NE(checked.out.find("FAILED: "), std::string::npos) << checked.out;
  EXPECT_NE(checked.err.find("1 of 2 teams did not play to the end"), std::string::npos)
      << checked.err;
  EXPECT_EQ(checked.err.find("no frame"), std::string::npos) << checked.err;
  EXPECT_FALSE(std::filesystem::exists(path("cup/tournament.db")));

  const CommandResult again = run({"tournament", "check-in", "cup", "RED", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["teams"].size(), 1U);

  const CommandResult unknown = run({"tournament", "check-in", "cup", "GON"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("unknown team 'GON'; did you mean 'GONE'?"), std::string::npos)
      << unknown.err;
}

TEST_F(League, DecideExplainsWhatIsMissing) {
  write("cup/cls.toml",
        "[tournament]\ncycles = 1\n[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.BLUE]\nendpoint = \"mock\"\n");

  EXPECT_EQ(run({"tournament", "decide", "cup"}).exit_code, 66);
  ASSERT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);

  const auto decide = [this](const std::vector<std::string>& words) {
    return run(joined({"tournament", "decide", "cup", "--match", "1"}, words));
  };
  EXPECT_EQ(decide({"--annul"}).exit_code, 2) << "without a reason";
  EXPECT_EQ(decide({"--reason", "x"}).exit_code, 2) << "without a decision";
  EXPECT_EQ(decide({"--annul", "--replay", "--reason", "x"}).exit_code, 2);
  EXPECT_EQ(decide({"--award", "3", "--reason", "x"}).exit_code, 2);
  EXPECT_EQ(decide({"--award", "1:0", "--penalties", "3:2", "--reason", "x"}).exit_code, 2);
  EXPECT_EQ(decide({"--as-played", "--reason", "x"}).exit_code, 2);
  EXPECT_EQ(run({"tournament", "decide", "cup"}).out, "no decisions\n");
  EXPECT_EQ(decide({"--award", "0:0", "--penalties", "3:2", "--reason", "x"}).exit_code, 0);
  EXPECT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);
  EXPECT_NE(run({"tournament", "decide", "cup"}).out.find("awarded 0:0"), std::string::npos);
}

TEST_F(League, ResultsCountNoAnnulledMatch) {
  write("cup/cls.toml",
        "[tournament]\ncycles = 1\nkeep_logs = \"all\"\n[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.BLUE]\nendpoint = \"mock\"\n");
  ASSERT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);
  const auto results = [this](const std::string& logs) { return run({"results", logs, "--json"}); };
  const std::size_t played = json::parse(results("cup").out)["matches"].size();
  ASSERT_EQ(played, 2U);
  ASSERT_THAT(
      run({"tournament", "decide", "cup", "--match", "1", "--annul", "--reason", "a protest"}),
      Exits(0));

  for (const char* logs : {"cup", "cup/", "cup/matches", "."}) {
    const CommandResult counted = results(logs);
    EXPECT_EQ(json::parse(counted.out)["matches"].size(), 1U) << logs;
    EXPECT_THAT(counted.err, HasSubstr("1 match left out: annulled")) << logs;
  }
  EXPECT_EQ(run({"stats", "cup", "--format", "csv"}).err, results("cup").err);
  const CommandResult named = results("cup/matches/000001-RED-vs-BLUE");
  EXPECT_EQ(json::parse(named.out)["matches"].size(), 1U) << "asked for by name";
}

TEST_F(League, RunNamesATournamentThatWasPerhapsMeant) {
  write("cls.toml",
        "[tournament]\ncycles = 1\n[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.BLUE]\nendpoint = \"mock\"\n");
  const CommandResult first = run({"tournament", "run", "spring"});
  EXPECT_THAT(first.err, Not(HasSubstr("a new tournament")));
  EXPECT_THAT(run({"tournament", "run", "sprin"}).err,
              HasSubstr("cls: sprin: a new tournament; did you mean 'spring'?"));
  EXPECT_THAT(run({"tournament", "run", "spring"}).err, Not(HasSubstr("a new tournament")));
}

// Only a wrong use of the command is a usage error.
TEST_F(League, DecideTellsAFailedWriteFromAWrongUse) {
  write("cup/cls.toml",
        "[tournament]\ncycles = 1\n[teams.RED]\nendpoint = \"mock\"\n"
        "[teams.BLUE]\nendpoint = \"mock\"\n");
  ASSERT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);
  std::filesystem::remove(path("cup/schedule.jsonl"));
  std::filesystem::create_directories(path("cup/schedule.jsonl/full"));

  const auto decide = [this](const std::string& match) {
    return run({"tournament", "decide", "cup", "--match", match, "--annul", "--reason", "x"});
  };
  EXPECT_EQ(decide("9").exit_code, 2);
  EXPECT_EQ(decide("1").exit_code, 74);
}

TEST_F(League, NamesMayBeNumbers) {
  const CommandResult result =
      run({"tournament", "plan", "cup", "--team", "A=mock", "--team", "B=mock", "--name", "2026",
           "--on-finish", "true", "--remote-folder", "2026.5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

constexpr const char* kThreeTeams =
    "[teams.RED]\nendpoint = \"mock\"\n[teams.BLUE]\nendpoint = \"mock\"\n"
    "[teams.GOLD]\nendpoint = \"mock\"\n";

// A team leaves after the first round, and takes its program along.
TEST_F(League, ATeamThatWithdrawsIsAwaitedNoMore) {
  const std::string stop = cls_binary().string() + " tournament stop " + path("cup").string();
  write("cup/cls.toml",
        "[tournament]\nformat = \"swiss\"\nrounds = 3\ncycles = 3\nswap_sides = false\n"
        "on_match_finish = \"test -e once || { touch once; " +
            stop +
            "; }\"\n[teams.A]\nendpoint = \"mock:hold\"\n[teams.B]\nendpoint = \"mock:hold\"\n"
            "[teams.C]\nendpoint = \"mock:hold\"\n[teams.F]\nendpoint = \"mock:f.json\"\n");
  write("cup/f.json", R"({"otherwise": "hold"})");
  run({"tournament", "run", "cup", "--quiet"});
  std::filesystem::remove(path("cup/f.json"));
  EXPECT_THAT(run({"tournament", "run", "cup", "--quiet"}).err, HasSubstr("f.json"));

  const std::vector<std::string> decide = {"tournament", "decide", "cup"};
  const auto withdraw = [&](const std::string& team) {
    return run(joined(decide, {"--withdraw", team, "--reason", "left the league"}));
  };
  EXPECT_THAT(withdraw("G").err, HasSubstr("--withdraw: unknown team 'G'"));
  EXPECT_EQ(run(joined(decide, {"--withdraw", "F", "--match", "1", "--reason", "x"})).exit_code, 2);
  const json before = report()["matches"];
  const auto played_before = static_cast<std::size_t>(
      std::ranges::count_if(before, [](const json& match) { return !match["score"].is_null(); }));
  const CommandResult left = withdraw("F");
  EXPECT_EQ(left.exit_code, 0) << left.err;
  EXPECT_THAT(left.out, HasSubstr("F has withdrawn: "));

  const CommandResult played = run({"tournament", "run", "cup", "--quiet"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(run(decide).out, HasSubstr("withdrawn: F"));
  const json document = report();
  EXPECT_EQ(document["complete"], true);
  ASSERT_GT(document["matches"].size(), played_before);
  for (std::size_t i = played_before; i < document["matches"].size(); ++i) {
    const json& match = document["matches"][i];
    const bool leaves = match["left"] == "F" || match["right"] == "F";
    EXPECT_TRUE(!leaves || match["forfeit"] == true) << match;
  }
}

// Three teams are equal where two go on.
TEST_F(League, OrganizersOrderEqualTeams) {
  write("cup/cls.toml",
        "[tournament]\nformat = \"stages\"\ncycles = 3\nswap_sides = false\n"
        "[[stages]]\nname = \"first\"\n"
        "[[stages]]\nname = \"final\"\nformat = \"knockout\"\nteams = 2\n"
        "[teams.A]\nendpoint = \"mock:hold\"\n[teams.B]\nendpoint = \"mock:hold\"\n"
        "[teams.C]\nendpoint = \"mock:hold\"\n");
  ASSERT_EQ(run({"tournament", "run", "cup", "--quiet"}).exit_code, 0);
  const std::string lot = run({"tournament", "plan", "cup"}).out;
  EXPECT_THAT(lot, HasSubstr("are equal; their order is a lot from the seed"));
  EXPECT_THAT(run({"tournament", "report", "cup"}).out, HasSubstr(" by lot"));

  // The one that the lot left out comes first now.
  const json table = report()["tables"][0]["standings"];
  const std::string last = table[2]["team"].get<std::string>();
  const std::string order =
      last + "," + table[0]["team"].get<std::string>() + "," + table[1]["team"].get<std::string>();
  const std::vector<std::string> decide = {"tournament", "decide",   "cup",      "--order",
                                           order,        "--reason", "penalties"};
  EXPECT_THAT(run(decide).err, HasSubstr("--redraw discards"));
  const CommandResult decided = run(joined(decide, {"--redraw"}));
  EXPECT_THAT(decided.out, HasSubstr("first: the order is " + order));

  ASSERT_EQ(run({"tournament", "run", "cup", "--quiet"}).exit_code, 0);
  EXPECT_EQ(report()["tables"][0]["standings"][0]["team"], last);
  EXPECT_THAT(run({"tournament", "report", "cup"}).out, HasSubstr(" by decision"));
  EXPECT_THAT(run({"tournament", "plan", "cup"}).out, HasSubstr("their order is a decision"));
}

TEST_F(League, PlanShowsWhenMatchesStart) {
  const std::string head = "[tournament]\ncycles = 5\nswap_sides = false\nconcurrency = 2\n";
  write("cup/cls.toml",
        head + "start_times = [\"2037-07-15 09:00\"]\nslot_minutes = 20\n" + kThreeTeams);
  const std::vector<std::string> plan = {"tournament", "plan", "cup"};
  const std::vector<std::string> utc = {"TZ=UTC"};
  const CommandResult shown = run(plan, utc);
  EXPECT_NE(shown.out.find("2037-07-15 09:00, server 2    2  round 1"), std::string::npos)
      << shown.out;
  EXPECT_NE(shown.out.find("2037-07-15 09:20, server 1    3  round 1"), std::string::npos);
  EXPECT_NE(shown.out.find("2 servers, a match every 20 minutes on each"), std::string::npos);
  const json document = json::parse(run({"tournament", "plan", "cup", "--json"}, utc).out);
  EXPECT_EQ(document["schedule"][2]["start"], "2037-07-15T09:20:00Z");

  // Afterwards the plan has the results, and the report no next match.
  ASSERT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);
  EXPECT_EQ(run(plan, utc).out.find("2037"), std::string::npos);
  EXPECT_EQ(report()["schedule"], json::array());

  for (const char* wrong : {"15.7.2037 09:00", "2037-02-30 09:00", "2037-07-15 09:00 later"}) {
    write("bad/cls.toml", head + "start_times = [\"" + std::string(wrong) + "\"]\n" + kThreeTeams);
    const CommandResult refused = run({"tournament", "plan", "bad"});
    EXPECT_EQ(refused.exit_code, 78) << wrong;
    EXPECT_NE(refused.err.find("must be YYYY-MM-DD HH:MM"), std::string::npos) << refused.err;
  }
}

// A time-out holds the next matches, also of a run that was killed and started again.
TEST_F(League, PauseHoldsMatchesUntilResume) {
  write("cup/cls.toml", std::string("[tournament]\ncycles = 5\n") + kThreeTeams);
  ASSERT_EQ(run({"tournament", "pause", "cup", "--reason", "x"}).exit_code, 66);
  ASSERT_THAT(run({"tournament", "work", "cup", "--index", "1", "--config", "cup/cls.toml"}),
              Exits(0));
  EXPECT_EQ(run({"tournament", "pause", "cup"}).exit_code, 2) << "without a reason";
  ASSERT_EQ(run({"tournament", "pause", "cup", "--reason", "network of BLUE"}).exit_code, 0);
  EXPECT_EQ(run({"tournament", "pause", "cup", "--reason", "y"}).out, "cup: is paused already\n");

  for (int kill = 0; kill < 2; ++kill) {
    Command held({cls_binary(), "tournament", "run", path("cup")}, {}, path("."));
    EXPECT_TRUE(held.wait_for_errors("paused: network of BLUE; cls tournament resume "));
    held.send_signal(SIGKILL);
    held.finish();
    EXPECT_EQ(report()["counts"]["finished"], 1) << "the one that was played before";
  }

  Command held({cls_binary(), "tournament", "run", path("cup")}, {}, path("."));
  EXPECT_TRUE(held.wait_for_errors("paused: "));
  EXPECT_EQ(run({"tournament", "resume", "cup"}).out, "cup: resumed\n");
  EXPECT_EQ(held.finish().exit_code, 0);

  const json document = report();
  EXPECT_EQ(document["counts"]["finished"], 6);
  ASSERT_EQ(document["pauses"].size(), 1u);
  EXPECT_EQ(document["pauses"][0]["reason"], "network of BLUE");
  EXPECT_FALSE(document["pauses"][0]["end"].is_null());
  EXPECT_NE(run({"tournament", "report", "cup"}).out.find("technical time-outs"),
            std::string::npos);
}

TEST_F(League, ArchiveHasTheNamesOfTheLeague) {
  write("cup/cls.toml",
        std::string("[tournament]\ncycles = 30\nswap_sides = false\n") + kThreeTeams);
  ASSERT_EQ(run({"tournament", "run", "cup"}).exit_code, 0);

  const json written = json::parse(run({"tournament", "archive", "cup", "--json"}, {"TZ=UTC"}).out);
  EXPECT_EQ(written["written"], 3);

  for (const json& match : written["matches"]) {
    const std::filesystem::path log = path(match["rcg"].get<std::string>());
    EXPECT_TRUE(
        std::regex_match(log.filename().string(),
                         std::regex("20[0-9]{12}-[A-Z]+_[0-9]+-vs-[A-Z]+_[0-9]+[.]rcg[.]gz")))
        << log;
    EXPECT_EQ(read_file(log).substr(0, 4), "ULG5");
    EXPECT_NE(read_file(path(match["rcl"].get<std::string>())).find("(kick"), std::string::npos);
  }
  const CommandResult again = run({"tournament", "archive", "cup"}, {"TZ=UTC"});
  EXPECT_EQ(again.out, "cup/archive: 0 matches written, 3 there already\n");
}

TEST_F(League, QualifyPacksLogsOfWholeMatches) {
  const std::vector<std::string> words = {"qualify",  "mock",        "mock:hold", "--mode",
                                          "lockstep", "--half-time", "10"};
  const CommandResult packed = run(words);
  ASSERT_EQ(packed.exit_code, 0) << packed.err;
  EXPECT_NE(packed.err.find("warning: 200 cycles a match; the league asks for whole matches"),
            std::string::npos);

  const CommandResult listed = tests::run({"tar", "-tzf", path("mock_logs.tar.gz").string()});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_TRUE(std::regex_match(listed.out,
                               std::regex("mock_logs/[0-9]+-mock_[0-9]+-vs-hold_[0-9]+[.]rcg\n"
                                          "mock_logs/[0-9]+-mock_[0-9]+-vs-hold_[0-9]+[.]rcl\n")))
      << listed.out;
  EXPECT_EQ(run(words).out, packed.out) << "nothing is played again";

  std::vector<std::string> others = words;
  others[2] = "mock:simple";
  EXPECT_EQ(run(others).exit_code, 73) << "the folder holds other matches";
  EXPECT_EQ(run({"qualify", "mock", "mock:hold", "--out", "logs.zip"}).exit_code, 2);
}

TEST_F(League, PresetOfMixedTeams) {
  ASSERT_THAT(run({"init", "cup", "--preset", "mixed", "--teams", "RED,BLUE,GREEN,GOLD"}),
              Exits(0));
  const CommandResult plan = run({"tournament", "plan", "cup"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_NE(plan.out.find("RED+BLUE"), std::string::npos) << plan.out;
  EXPECT_EQ(run({"init", "odd", "--preset", "mixed", "--teams", "A,B,C,D,E"}).exit_code, 2);
  ASSERT_EQ(run({"init", "mocks", "--preset", "mixed"}).exit_code, 0);
  EXPECT_THAT(run({"tournament", "run", "mocks", "--mode", "lockstep", "--cycles", "5"}), Exits(0));
}

}  // namespace
}  // namespace cls::tests
