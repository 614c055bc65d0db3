// Features of servers of version 19, and servers before it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "player/world/planner_parameters.h"
#include "proxy/agent/player_agent.h"
#include "tests/proxy/agent/scripted_server.h"

namespace cls::proxy {
namespace {

using testing::Contains;
using testing::Not;

struct Connected {
  tests::ScriptedServer server;
  std::unique_ptr<PlayerAgent> agent;
  std::vector<std::string> sent;

  Connected(int version, bool leg_dashes, bool gaussian_see) {
    server.version = version;
    auto parameters = std::make_shared<player::PlannerParameters>();
    parameters->leg_dashes = leg_dashes ? 1 : 0;
    parameters->gaussian_see = gaussian_see ? 1 : 0;
    AgentOptions options;
    options.team_name = "us";
    options.planner = parameters;
    agent = std::make_unique<PlayerAgent>(server.open(), options);

    EXPECT_TRUE(agent->connect());
    for (int i = 0; i < 2; ++i) {
      server.serve();
      agent->perceive();
    }

    sent = server.take(1);
    EXPECT_TRUE(agent->ready()) << agent->server().refusal;
    EXPECT_EQ(agent->server().errors.errors, 0);
  }
};

TEST(Version19, BringsTwoLegDashesAndGaussianSee) {
  Connected on(19, true, true);
  EXPECT_EQ(on.agent->options().protocol, 19);
  EXPECT_TRUE(on.agent->world().leg_dashes);
  EXPECT_THAT(on.sent, Contains("(gaussian_see)"));
  EXPECT_FALSE(on.agent->world().self.gaussian_see) << "not confirmed yet";
  on.server.send(1, "(ok gaussian_see)");
  on.agent->perceive();
  EXPECT_TRUE(on.agent->world().self.gaussian_see);
}

TEST(Version19, UsesWhatTheParametersAllow) {
  const Connected off(19, false, false);
  EXPECT_FALSE(off.agent->world().leg_dashes);
  EXPECT_THAT(off.sent, Not(Contains("(gaussian_see)")));
}

TEST(Version19, BecomesVersion18OnOlderServers) {
  const Connected older(18, true, true);
  EXPECT_EQ(older.agent->options().protocol, 18);
  EXPECT_FALSE(older.agent->world().leg_dashes);
  EXPECT_THAT(older.sent, Not(Contains("(gaussian_see)")));
}

TEST(Version19, ReportsRefusalOfBothVersions) {
  tests::ScriptedServer server;
  server.refusal = "(error no_more_player_or_goalie_or_illegal_client_version)";
  AgentOptions options;
  options.team_name = "us";
  PlayerAgent agent(server.open(), options);

  ASSERT_TRUE(agent.connect());
  for (int i = 0; i < 3; ++i) {
    server.serve();
    agent.perceive();
  }

  EXPECT_EQ(agent.server().refusal, "no_more_player_or_goalie_or_illegal_client_version");
  EXPECT_EQ(agent.server().errors.errors, 1);
}

}  // namespace
}  // namespace cls::proxy
