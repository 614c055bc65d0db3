// Messages between match server and players, compared with those of rcssserver.
#include "simulator/sessions/match_server.h"

#include <gtest/gtest.h>

#include "soccer/messages/parameter_message.h"
#include "tests/simulator/sessions/match_clients.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::simulator {
namespace {

class MatchServerTest : public MatchClients {
 protected:
  void SetUp() override { start(); }

  /// Connects a player; returns the text of the error, or an empty string.
  std::string connect(const std::string& request) {
    const ClientId client = MatchClients::connect(request);
    if (client != kNoClient) slot_ = client;
    return refusal_;
  }

  Slot slot_ = kNoPlayer;  ///< of the last client
};

TEST_F(MatchServerTest, CompletesHandshakeLikeRcssserver) {
  const std::string text = tests::read_file(tests::fixture("simulator/handshake-v18.txt.gz"));
  const auto transcript = tests::read_transcript(text);
  ASSERT_EQ(transcript.size(), 23u);

  MatchConfig config;
  ASSERT_TRUE(soccer::parse(transcript[2].message, config.server));
  ASSERT_TRUE(soccer::parse(transcript[3].message, config.player));

  start(config);
  for (int unum = 1; unum <= 10; ++unum) {
    ASSERT_EQ(connect(std::string(transcript[0].message)), "");
  }
  const auto greeting = messages(slot_);
  ASSERT_EQ(greeting.size(), transcript.size() - 1);
  for (std::size_t i = 0; i < greeting.size(); ++i) {
    EXPECT_EQ(greeting[i], transcript[i + 1].message);
  }
}

TEST_F(MatchServerTest, RefusesInvalidRequestsLikeRcssserver) {
  const std::pair<const char*, const char*> cases[] = {
      {"(init  (version 19))", "(error illegal_teamname)"},
      {"(init T\303\253am (version 19))", "(error illegal_teamname_or_too_long_teamname)"},
      {"(init ThisNameIsTooLong (version 19))", "(error illegal_teamname_or_too_long_teamname)"},
      {"(init LeftTeam (foo))", "(error illegal_command_form)"},
      {"(init LeftTeam (version x))", "(error illegal_command_form)"},
      {"(init LeftTeam (version 20))",
       "(error no_more_player_or_goalie_or_illegal_client_version)"},
      {"(reconnect A 1)", "(error no_such_team_or_player)"},
      {"(init A", "(error illegal_teamname_or_too_long_teamname)"},
      {"(dash 100)", "(error unknown_command)"},
  };
  for (const auto& [request, error] : cases) EXPECT_EQ(connect(request), error) << request;
}

TEST_F(MatchServerTest, AcceptsTwoTeamsOfElevenWithOneGoalieEach) {
  for (int unum = 1; unum <= 11; ++unum) {
    EXPECT_EQ(connect(unum == 1 ? "(init A (version 18) (goalie))" : "(init A (version 18))"), "");
    EXPECT_EQ(messages(slot_).front(), "(init l " + std::to_string(unum) + " before_kick_off)");
  }
  const std::string full = "(error no_more_player_or_goalie_or_illegal_client_version)";
  EXPECT_EQ(connect("(init A (version 18))"), full);
  EXPECT_EQ(connect("(init B (version 18) (goalie))"), "");
  EXPECT_EQ(messages(slot_).front(), "(init r 1 before_kick_off)");
  EXPECT_EQ(connect("(init B (version 18) (goalie))"), full);
  EXPECT_EQ(connect("(init C (version 18))"), "(error no_more_team)");
}

TEST_F(MatchServerTest, AssignsTeamNameEvenIfRequestFails) {
  EXPECT_NE(connect("(init A (version 20))"), "");
  EXPECT_EQ(connect("(init B (version 18))"), "");
  EXPECT_EQ(messages(slot_).front(), "(init r 1 before_kick_off)");
}

TEST_F(MatchServerTest, RejectsFixedTeamNames) {
  MatchConfig config;
  config.server.fixed_teamname_l = "Home";
  start(config);
  EXPECT_EQ(connect("(init Home (version 18))"), "(error conflict_with_fixed_teamname)");
}

TEST_F(MatchServerTest, RepliesToCommandsLikeRcssserver) {
  connect("(init LeftTeam (version 19))");
  const std::pair<const char*, Texts> cases[] = {
      {"(turn abc)", {"(error illegal_command_form)"}},
      {"(foo)", {"(error illegal_command_form)"}},
      {"", {"(error illegal_command_form)"}},
      {"(score)", {"(score 0 0 0)"}},
      {"(synch_see)", {"(ok synch_see)"}},
      {"(gaussian_see)", {"(ok gaussian_see)"}},
      {"(clang (ver 7 8))", {"(ok clang (ver 7 8))"}},
      {"(ear (off Nope))", {"(error no team with name Nope)"}},
      {"(ear (off opp))", {}},
      {"(say \"hello\")", {}},
      {"(turn 30)(turn_neck 20)", {}},
      {"(move 10 10)", {}},  // the body command of this cycle was executed
  };

  for (const auto& [command, expected] : cases) {
    EXPECT_EQ(answers(slot_, command), expected) << command;
  }
}

TEST_F(MatchServerTest, ExecutesCommandsBeforeSyntaxError) {
  connect("(init A (version 18))");
  EXPECT_EQ(answers(slot_, "(score)(say \"abc\")(turn abc)(score)"),
            (Texts{"(score 0 0 0)", "(error illegal_command_form)"}));
  EXPECT_EQ(server_->world().player(slot_).counters.say, 1);
}

TEST_F(MatchServerTest, WarnsOfMissingNulsAndOpponentField) {
  connect("(init A (version 18))");
  EXPECT_EQ(answers(slot_, "(score)", false),
            (Texts{"(warning message_not_null_terminated)", "(score 0 0 0)"}));
  EXPECT_EQ(answers(slot_, "(move 10 10)"), (Texts{"(warning moving_to_opponent_field)"}));
}

TEST_F(MatchServerTest, SendsSenseBodyOnRequest) {
  connect("(init A (version 18))");
  const Texts answer = answers(slot_, "(sense_body)");
  ASSERT_EQ(answer.size(), 1u);
  EXPECT_TRUE(answer[0].starts_with("(sense_body 0 (view_mode high normal)"));
}

TEST_F(MatchServerTest, LogsRequestsAndDatagramsAsReceived) {
  connect("(init A (version 18) (goalie))");
  server_->receive(slot_, "(turn 0)(done)");
  server_->receive(slot_, "garbage");
  server_->execute();
  server_->step();
  server_->receive(slot_, "(bye)");
  server_->execute();
  EXPECT_EQ(text_log_.bytes(),
            "0,0\tRecv A_1: (init A (version 18) (goalie))\n"
            "0,0\tRecv A_1: (turn 0)(done)\n"
            "0,0\tRecv A_1: garbage\n"
            "0,1\tRecv A_1: (bye)\n");
}

TEST_F(MatchServerTest, SendsFullStateToEnabledSide) {
  MatchConfig config;
  config.server.fullstate_l = true;
  start(config);
  connect("(init A (version 18))");
  const Slot left = slot_;
  connect("(init B (version 18))");
  const Slot right = slot_;
  messages(left);
  messages(right);
  step();
  const Texts to_left = messages(left);

  ASSERT_EQ(to_left.size(), 2u);
  EXPECT_TRUE(to_left[1].starts_with("(fullstate 0 (pmode before_kick_off)"));
  EXPECT_EQ(messages(right).size(), 1u);
}

TEST_F(MatchServerTest, SendsTypesAtFirstKickOffAndToLateClients) {
  MatchConfig config;
  config.server.auto_mode = true;
  config.server.connect_wait = 1;
  start(config);
  connect("(init A (version 18))");
  connect("(init A (version 18))");
  const Slot left = slot_;
  connect("(init B (version 18))");
  const Slot right = slot_;
  messages(left);
  messages(right);
  server_->step();

  // The first player keeps type 0, the second gets the next one.
  EXPECT_EQ(messages(left), (Texts{"(change_player_type 2 1)", "(hear 0 referee kick_off_l)"}));
  EXPECT_EQ(messages(right), (Texts{"(change_player_type 2)", "(hear 0 referee kick_off_l)"}));

  connect("(init A (version 18))");
  const Texts greeting = messages(slot_);

  EXPECT_EQ(greeting.front(), "(init l 3 kick_off_l)");
  EXPECT_EQ(greeting[greeting.size() - 2], "(change_player_type 2 1)");
  EXPECT_EQ(greeting.back(), "(ok synch_see)");
}

TEST_F(MatchServerTest, AllowsReconnectOutsidePlayOn) {
  connect("(init A (version 17))");
  const Slot slot = slot_;
  answers(slot, "(ear (off our))(turn 30)");
  server_->step();
  server_->receive(slot, "(bye)");
  server_->execute();

  EXPECT_FALSE(server_->world().player(slot).enabled);
  EXPECT_EQ(connect("(reconnect A 2)"), "(error no_such_team_or_player)");
  EXPECT_EQ(connect("(reconnect A 1)"), "");
  EXPECT_EQ(slot_, slot);

  const Texts greeting = messages(slot);
  EXPECT_EQ(greeting.front(), "(reconnect l before_kick_off)");
  EXPECT_TRUE(greeting[1].starts_with("(server_param "));
  EXPECT_TRUE(greeting.back().starts_with("(player_type (id 17)"));
  EXPECT_TRUE(server_->world().player(slot).enabled);
  EXPECT_TRUE(server_->world().player(slot).ears.complete[0]) << "ears are new";
  EXPECT_EQ(server_->world().player(slot).counters.turn, 1) << "counters stay";
}

TEST_F(MatchServerTest, DropsFloodOfOneClientWithoutAffectingOthers) {
  connect("(init A (version 18))");
  const Slot flooding = slot_;
  connect("(init A (version 18))");
  for (int i = 0; i < 100000; ++i) server_->receive(flooding, "(score)");
  server_->receive(slot_, "(score)");
  messages(slot_);
  messages(flooding);
  server_->execute();
  EXPECT_EQ(messages(flooding).size(), static_cast<std::size_t>(ReceiveQuota::kMaxDatagrams));
  EXPECT_EQ(messages(slot_), (Texts{"(score 0 0 0)"}));
}

TEST_F(MatchServerTest, ResetsReceiveQuotaInEachStep) {
  connect("(init A (version 18))");
  messages(slot_);
  const auto answers_to = [this](const std::string& datagram, int times) {
    for (int i = 0; i < times; ++i) server_->receive(slot_, datagram);
    server_->execute();
    return messages(slot_).size();
  };

  EXPECT_EQ(answers_to("(score)", 200), 200U);
  EXPECT_EQ(answers_to("(score)", 200), 56U);
  server_->step();
  messages(slot_);
  EXPECT_EQ(answers_to("(score)", 1), 1U);

  // Long datagrams use up the quota sooner.
  std::string many;
  while (many.size() < 8000) many += "(sense_body)";
  const std::size_t each = many.size() / std::string("(sense_body)").size();
  EXPECT_EQ(answers_to(many, 10), 2 * each);
}

TEST_F(MatchServerTest, RecognizesDoneBeyondReceiveQuota) {
  connect("(init A (version 18))");
  server_->sense();
  server_->think();
  for (int i = 0; i < 300; ++i) server_->receive(slot_, "(score)");
  EXPECT_TRUE(server_->awaits(slot_));
  server_->receive(slot_, "(turn 10)(done)");
  EXPECT_FALSE(server_->awaits(slot_));
}

// Otherwise a cycle would wait twice for an unresponsive player.
TEST_F(MatchServerTest, DoesNotAwaitPlayersWithCoaches) {
  connect("(init A (version 18))");
  server_->sense();
  server_->think();
  EXPECT_TRUE(server_->awaits_any_client());
  EXPECT_FALSE(server_->awaits_coaches());
}

TEST_F(MatchServerTest, LimitsSayMessagesPerSpeaker) {
  connect("(init A (version 18))");
  const Slot flooding = slot_;
  connect("(init A (version 18))");
  std::string says;
  for (int i = 0; i < 700; ++i) says += "(say \"abc\")";
  server_->receive(flooding, says);
  server_->receive(slot_, "(ear (on our partial))");
  server_->execute();
  server_->step();
  messages(slot_);
  server_->sense();
  Texts heard = messages(slot_);
  std::erase_if(heard, [](const std::string& text) { return !text.starts_with("(hear "); });

  EXPECT_EQ(heard.size(), static_cast<std::size_t>(PendingMessages::kMaxMessagesPerSpeaker));
}

}  // namespace
}  // namespace cls::simulator
