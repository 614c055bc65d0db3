// Plans of `run:` sides, `team:` sides and external servers, without starting anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "match/programs/server_plan.h"
#include "match/programs/team_folder.h"
#include "match/terms/run_command.h"
#include "match/terms/server_choice.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

TEST(RunCommand, QuotesPlaceholderValuesForTheShell) {
  RunValues values;
  values.port = 21234;
  values.side = soccer::Side::kRight;
  values.team_name = "A+B";
  values.seed = 7;
  EXPECT_EQ(fill_in("x {port} {side} {name} {seed}", values), "x 21234 right A+B 7");
  EXPECT_EQ(fill_in("{port}{port} {", values), "2123421234 {");
  EXPECT_EQ(fill_in("${port} {a,b} {print} {} {port", values), "${port} {a,b} {print} {} {port");
  values.team_name = "it's";
  EXPECT_EQ(fill_in("{name}", values), "'it'\\''s'");
}

TEST(RunCommand, IgnoresOtherBraces) {
  EXPECT_TRUE(check_run_command("awk '{print}' x; brain {port}"));
  EXPECT_TRUE(check_run_command("brain '{\"a\": {port}}'"));
  EXPECT_EQ(check_run_command("brain {port} {nmae}").error().message,
            "unknown placeholder {nmae}; did you mean {name}?");
  EXPECT_FALSE(check_run_command("brain ${port}"));
}

TEST(RunCommand, NamesLogAfterSide) {
  RunValues values;
  values.port = 5;
  const process::CommandPlan plan = run_plan("brain --port {port}", values, "/match");
  EXPECT_EQ(plan.name, "left Playmaker");
  EXPECT_EQ(plan.argv, (Words{"/bin/sh", "-c", "brain --port 5"}));
  EXPECT_EQ(plan.log, "/match/left-playmaker.log");
}

TEST(ServerChoice, ParsesProgramsAndAddressesAndSuggestsCorrections) {
  EXPECT_EQ(parse_server("embedded")->kind, ServerChoice::Kind::kEmbedded);
  EXPECT_EQ(parse_server("rcssserver")->program, "rcssserver");
  EXPECT_EQ(parse_server("/opt/a:b/rcssserver")->kind, ServerChoice::Kind::kProgram);
  EXPECT_EQ(parse_server("./my-server")->program, "./my-server");

  const auto address = parse_server("10.0.0.2:6000");
  EXPECT_EQ(address->kind, ServerChoice::Kind::kAddress);
  EXPECT_EQ(address->host, "10.0.0.2");
  EXPECT_EQ(address->port, 6000);
  EXPECT_EQ(parse_server("rcsserver").error().message,
            "--server 'rcsserver': did you mean 'rcssserver'? (embedded, rcssserver, the PATH of a "
            "server, or HOST:PORT)");
  EXPECT_FALSE(parse_server(""));
  EXPECT_FALSE(parse_server("host:0"));
  EXPECT_FALSE(parse_server(":6000"));
  EXPECT_FALSE(parse_server("host:6000x"));
}

TEST(ServerChoice, ParsesModes) {
  for (const auto mode : {MatchMode::kLockstep, MatchMode::kSynch, MatchMode::kRealtime}) {
    EXPECT_EQ(*parse_mode(name(mode)), mode);
  }
  EXPECT_EQ(parse_mode("sync").error().message, "--mode 'sync': did you mean 'synch'?");
  EXPECT_EQ(parse_mode("fast").error().message,
            "--mode 'fast': must be lockstep or synch or realtime");
}

ServerSetup usual_setup() {
  ServerSetup setup;
  setup.program = {"/usr/bin/rcssserver"};
  setup.folder = "/runs/x y";
  setup.ports = {20001, 20005, 20009};
  return setup;
}

TEST(ServerCommand, SetsRequiredAndChangedParametersOnly) {
  ServerSetup setup = usual_setup();
  setup.server.half_time = 60;
  setup.server.kick_rand = 0.0;
  setup.player.pt_max = 3;
  const process::CommandPlan plan = server_plan(setup);

  EXPECT_EQ(plan.argv.front(), "/usr/bin/rcssserver");
  EXPECT_THAT(plan.argv,
              IsSupersetOf({"server::auto_mode=on", "server::synch_mode=on", "server::port=20001",
                            "server::coach_port=20005", "server::olcoach_port=20009",
                            "server::half_time=60", "server::kick_rand=0", "player::pt_max=3",
                            "server::game_log_fixed=on", "server::game_log_fixed_name='match'",
                            "server::connect_wait=1000000"}));
  EXPECT_THAT(plan.argv, Each(AllOf(Not(HasSubstr("stamina")), Not(HasSubstr(" ")))));
  EXPECT_EQ(plan.folder, "/runs/x y");
  EXPECT_EQ(plan.environment,
            (std::vector<process::EnvironmentChange>{{"RCSS_CONF_DIR", "/runs/x y/server-conf"},
                                                     {"USER", std::nullopt},
                                                     {"USERNAME", std::nullopt}}));
}

TEST(ServerCommand, DisablesSynchModeInRealTime) {
  ServerSetup setup = usual_setup();
  setup.mode = MatchMode::kRealtime;
  EXPECT_THAT(server_plan(setup).argv, Contains("server::synch_mode=off"));
  EXPECT_THAT(server_plan(setup).argv, Not(Contains("server::synch_mode=on")));
}

TEST(ServerCommand, QuotesTextLikeRcssserverParsesIt) {
  EXPECT_EQ(server_argument("server::port", "6000", false), Words{"server::port=6000"});
  EXPECT_EQ(server_argument("server::x", "2024abc", true), Words{"server::x='2024abc'"});
  EXPECT_EQ(server_argument("server::x", "it's", true), Words{"server::x=\"it's\""});
  EXPECT_EQ(server_argument("server::x", "a b", true), (Words{"server::x=", "'a b'"}));
}

class TeamFolder : public testing::Test {
 protected:
  void add(const std::string& name, bool executable = true) {
    std::ofstream(path() / name) << "#!/bin/sh\n";
    ::chmod((path() / name).c_str(), executable ? 0755 : 0644);
  }
  fs::path path() const { return folder_.path(); }

 private:
  tests::TemporaryFolder folder_;
};

TEST_F(TeamFolder, StartsGoalieFirstAndCoachLast) {
  add("start");
  add("start.sh");
  add("kill");
  TeamValues values;
  values.side = soccer::Side::kRight;
  values.folder = "/match";
  values.host = "127.0.0.1";
  const auto plan = team_plan(path(), values);

  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->agents.size(), 12U);
  EXPECT_FALSE(plan->takes_ports);
  EXPECT_FALSE(plan->takes_name);

  const process::CommandPlan& goalie = plan->agents.front().command;
  const std::string team = fs::canonical(path()).string();
  EXPECT_EQ(goalie.argv, (Words{team + "/start", "127.0.0.1", team, "1", "6000", "6002"}));
  EXPECT_EQ(goalie.folder, team);
  EXPECT_EQ(goalie.name, "right player 1");
  EXPECT_EQ(goalie.log, "/match/right-player-01.log");
  EXPECT_EQ(plan->agents.back().command.argv[3], "12");
  EXPECT_EQ(plan->agents.back().command.name, "right coach");
  ASSERT_EQ(plan->kills.size(), 1u);
  EXPECT_EQ(plan->kills[0].argv, Words{team + "/kill"});

  values.coach = false;
  EXPECT_EQ(team_plan(path(), values)->agents.size(), 11U);
}

TEST_F(TeamFolder, UsesStartShWithoutStart) {
  add("start.sh");
  TeamValues values;
  values.folder = "/match";
  values.ports = {20001, 20005, 20009};
  values.team_name = "helios";
  const auto plan = team_plan(path(), values);

  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->contract, TeamPlan::Contract::kStartAll);
  EXPECT_TRUE(plan->takes_ports);
  EXPECT_EQ(plan->agents.size(), 1U);
  EXPECT_EQ(plan->agents.front().command.argv,
            (Words{fs::canonical(path()).string() + "/start.sh", "-h", "127.0.0.1", "-p", "20001",
                   "-P", "20009", "-t", "helios"}));
  EXPECT_TRUE(plan->kills.empty());
}

TEST_F(TeamFolder, ReportsMissingScripts) {
  const std::string name = "team folder " + path().string();
  EXPECT_EQ(team_plan(path() / "none", {}).error().message, name + "/none: no such folder");
  EXPECT_EQ(team_plan("/dev/null", {}).error().message,
            "team folder /dev/null: a file, not a folder");
  EXPECT_EQ(team_plan(path(), {}).error().message, name + ": neither start nor start.sh in it");
  add("start", false);
  EXPECT_EQ(team_plan(path(), {}).error().message,
            name + ": " + fs::canonical(path()).string() + "/start is not executable");
}

}  // namespace
}  // namespace cls::match
