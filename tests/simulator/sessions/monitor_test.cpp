// Monitors: admission, messages and commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/simulator/sessions/match_clients.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;

class MonitorTest : public MatchClients {
 protected:
  MonitorTest() { start({}); }

  void start(MatchConfig config) {
    config.seed = 7;
    MatchClients::start(config);
  }

  void step() {
    server_->execute();
    MatchClients::step();
  }
};

TEST_F(MonitorTest, ReceivesParametersThenEveryStep) {
  const ClientId monitor = connect("(dispinit version 5)");
  const auto first = messages(monitor);
  ASSERT_EQ(first.size(), 20u);
  EXPECT_TRUE(first[0].starts_with("(server_param "));
  EXPECT_TRUE(first[1].starts_with("(player_param "));
  EXPECT_TRUE(first[19].starts_with("(player_type (id 17)"));
  step();
  step();
  const auto shows = messages(monitor);
  ASSERT_EQ(shows.size(), 2u);
  EXPECT_TRUE(
      shows[1].starts_with("(show 0 (pm 1) (tm null null 0 0) ((b) 0 0 0 0) ((l 1) 0 0 -3 "
                           "-37 0 0 0 0 (v h "));
}

TEST_F(MonitorTest, ReceivesFormOfItsVersion) {
  const ClientId json = connect("(dispinit version -1)");
  const ClientId v1 = connect("(dispinit)");
  const ClientId v2 = connect("(dispinit version 2)");
  const ClientId v3 = connect("(dispinit version 3)");
  const ClientId v4 = connect("(dispinit version 4)");
  EXPECT_TRUE(messages(v1).empty());
  EXPECT_EQ(messages(v2).size(), 20u);
  EXPECT_TRUE(messages(json)[0].starts_with("{\"server_param\":{"));

  messages(v3);
  messages(v4);
  step();
  EXPECT_TRUE(messages(json).at(0).starts_with(R"({"show":{"time":0,"stime":1,"mode":"before_k)"));
  EXPECT_EQ(messages(v1).at(0).size(), 2052u);
  EXPECT_EQ(messages(v2).at(0).size(), 2056u);

  // Unlike rcssserver, which sends all monitors the form that the first one requested.
  EXPECT_THAT(messages(v3).at(0), HasSubstr("(s 8000 1 1)"));
  EXPECT_THAT(messages(v4).at(0), HasSubstr("(s 8000 1 1 130600)"));
}

TEST_F(MonitorTest, IsRefusedWithUnknownVersionOrBeyondMaximum) {
  for (const char* request : {"(dispinit version 6)", "(dispinit version 0)",
                              "(dispinit version -2)", "(dispinit version 1e99)"}) {
    EXPECT_EQ(connect(request), kNoClient) << request;
    EXPECT_EQ(refusal_, "(error illegal_client_version)");
  }
  MatchConfig config;
  config.server.max_monitors = 1;
  start(config);
  EXPECT_NE(connect("(dispinit)"), kNoClient);
  EXPECT_EQ(connect("(dispinit)"), kNoClient);
  EXPECT_EQ(refusal_, "(error no_more_monitor)");
}

TEST_F(MonitorTest, FreesSlotOnDisconnect) {
  MatchConfig config;
  config.server.max_monitors = 1;
  start(config);
  const ClientId first = connect("(dispinit version 5)");
  server_->receive(first, "(dispbye)");
  step();
  EXPECT_EQ(server_->connection(first), nullptr);
  EXPECT_EQ(connect("(dispinit version 5)"), first);
}

TEST_F(MonitorTest, ReceivesErrorForUnknownCommand) {
  const ClientId monitor = connect("(dispinit version 3)");
  EXPECT_EQ(answers(monitor, "(foo)"), (Texts{"(msg 0 1 \"(error illegal_command_form)\")"}));
  messages(monitor);
  server_->receive(monitor, "(dispstart)", false);
  EXPECT_EQ(messages(monitor).at(0), "(msg 0 1 \"(warning message_not_null_terminated)\")");
}

TEST_F(MonitorTest, StartsMatch) {
  const ClientId player = connect("(init A (version 18))");
  const ClientId monitor = connect("(dispinit version 5)");
  messages(player);
  server_->receive(monitor, "(dispstart)");
  EXPECT_EQ(world().mode, PlayMode::kKickOffLeft);
  const auto heard = messages(player);
  EXPECT_EQ(heard.back(), "(hear 0 referee kick_off_l)");
  step();
  EXPECT_EQ(messages(monitor).back().substr(0, 15), "(show 1 (pm 4) ");
}

TEST_F(MonitorTest, CallsFoulsAndDropBalls) {
  const ClientId player = connect("(init A (version 18))");
  const ClientId monitor = connect("(dispinit version 5)");
  messages(player);
  server_->receive(monitor, "(dispfoul 160 -80 1)");
  EXPECT_EQ(messages(player), (Texts{"(hear 0 referee foul_r)", "(hear 0 referee free_kick_l)"}));
  EXPECT_EQ(world().ball.position, (Vec2{10.0, -5.0}));
  EXPECT_EQ(world().mode, PlayMode::kFreeKickLeft);
  server_->receive(monitor, "(dispfoul -160 80 0)");
  EXPECT_EQ(messages(player), (Texts{"(hear 0 referee drop_ball)", "(hear 0 referee play_on)"}));
  EXPECT_EQ(world().ball.position, (Vec2{-10.0, 5.0}));
}

TEST_F(MonitorTest, MovesDiscardsAndBooksPlayers) {
  const ClientId player = connect("(init A (version 18))");
  connect("(init A (version 18))");
  const ClientId monitor = connect("(dispinit version 5)");
  server_->receive(monitor, "(dispplayer 1 1 -320 160 90)");
  EXPECT_EQ(world().player(Side::kLeft, 1).position, (Vec2{-20.0, 10.0}));
  EXPECT_NEAR(world().player(Side::kLeft, 1).body, 1.5708, 1e-4);

  messages(player);
  server_->receive(monitor, "(dispcard 1 1 yellow)");
  EXPECT_EQ(messages(player).at(0), "(hear 0 referee yellow_card_l_1)");

  server_->receive(monitor, "(dispdiscard 1 2)");
  EXPECT_FALSE(world().player(Side::kLeft, 2).enabled);
  EXPECT_TRUE(world().player(Side::kLeft, 2).has(state::kDiscard));

  server_->receive(monitor, "(dispcard 1 1 red)");
  EXPECT_FALSE(world().player(Side::kLeft, 1).enabled);
  // Players that are not connected are moved too, unknown players are not; any angle is accepted.
  server_->receive(monitor, "(dispplayer -1 5 16 0 378)");
  EXPECT_EQ(world().player(Side::kRight, 5).position, (Vec2{1.0, 0.0}));
  EXPECT_NEAR(world().player(Side::kRight, 5).body, 6.5973, 1e-4);
  EXPECT_EQ(answers(monitor, "(dispplayer 2 5 0 0 0)"), Texts());
}

TEST_F(MonitorTest, ReceivesInitialBodyAngleOfPlayers) {
  const ClientId monitor = connect("(dispinit version 3)");
  EXPECT_EQ(world().player(Side::kRight, 1).body, 0.0);
  connect("(init A (version 18))");
  connect("(init B (version 18))");
  EXPECT_NEAR(world().player(Side::kRight, 1).body, 3.1416, 1e-4);
  EXPECT_EQ(world().player(Side::kRight, 2).body, 0.0);
  messages(monitor);
}

TEST_F(MonitorTest, ReceivesFocusPointsInTenThousandths) {
  const ClientId player = connect("(init A (version 18))");
  const ClientId text = connect("(dispinit version 5)");
  const ClientId json = connect("(dispinit version -1)");
  messages(text);
  messages(json);
  server_->receive(player, "(change_focus 1.00004 0.00002)");
  step();
  EXPECT_THAT(messages(text).at(0), HasSubstr("(fp 1 0)"));
  EXPECT_THAT(messages(json).at(0), HasSubstr("\"fdist\":1,\"fdir\":0,"));
}

TEST_F(MonitorTest, ReceivesMessagesWithSendComms) {
  MatchConfig config;
  config.server.send_comms = true;
  start(config);
  const ClientId player = connect("(init A (version 18))");
  const ClientId monitor = connect("(dispinit version 5)");
  messages(monitor);
  server_->receive(monitor, "(dispstart)");
  EXPECT_EQ(messages(monitor).back(), "(msg 0 1 \"(referee kick_off_l)\")");
  server_->receive(player, "(say \"abc\")");
  server_->execute();
  EXPECT_EQ(messages(monitor).at(0), "(msg 0 1 \"((player A 1) abc)\")");
}

TEST_F(MonitorTest, ReceivesTypeChanges) {
  const ClientId monitor = connect("(dispinit version 5)");
  connect("(init A (version 18))");
  connect("(init A (version 18))");
  messages(monitor);
  server_->receive(monitor, "(dispstart)");
  EXPECT_EQ(messages(monitor), (Texts{"(msg 0 1 \"(change_player_type l 2 1)\")"}));
}

TEST_F(MonitorTest, ExecutesTrainerCommandsInTrainerMode) {
  ClientId monitor = connect("(dispinit version 5)");
  EXPECT_EQ(answers(monitor, "(move (ball) 10 5)").at(0),
            "(msg 0 1 \"(error illegal_command_form)\")");

  MatchConfig config;
  config.server.coach_w_referee = true;
  start(config);
  monitor = connect("(dispinit version 5)");

  EXPECT_EQ(answers(monitor, "(move (ball) 10 5)").at(0), "(msg 0 1 \"(ok move)\")");
  EXPECT_EQ(world().ball.position, (Vec2{10.0, 5.0}));
  EXPECT_EQ(answers(monitor, "(change_mode drop_ball)").back(), "(msg 0 1 \"(ok change_mode)\")");
  EXPECT_EQ(world().mode, PlayMode::kDropBall);
  EXPECT_EQ(answers(monitor, "(recover)").back(), "(msg 0 1 \"(ok recover)\")");
  EXPECT_EQ(answers(monitor, "(eye on)").back(), "(msg 0 1 \"(error illegal_command_form)\")");
  EXPECT_EQ(answers(monitor, "(change_mode nonsense)").back(),
            "(msg 0 1 \"(error illegal_mode)\")");
}

TEST_F(MonitorTest, CanBeMadeReadOnly) {
  const ClientId monitor = connect("(dispinit version 5)");
  server_->make_monitors_read_only();
  server_->receive(monitor, "(dispstart)");
  EXPECT_EQ(world().mode, PlayMode::kBeforeKickOff);
}

TEST_F(MonitorTest, MayCommandOnListeningPortOnlyInVersion1) {
  const ClientId old = connect("(dispinit)");
  const ClientId monitor = connect("(dispinit version 4)");
  messages(monitor);
  server_->receive_on_listening_port(monitor, "(dispstart)", true);
  EXPECT_EQ(world().mode, PlayMode::kBeforeKickOff);
  EXPECT_EQ(messages(monitor).at(0), "(msg 0 1 \"(error only_init_allowed_on_init_port)\")");
  server_->receive_on_listening_port(old, "(dispstart)", true);
  EXPECT_EQ(world().mode, PlayMode::kKickOffLeft);
}

}  // namespace
}  // namespace cls::simulator
