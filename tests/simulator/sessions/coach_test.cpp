// Coaches and the trainer in a match, in addition to the conversations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "simulator/server/lockstep_server.h"
#include "tests/simulator/sessions/match_clients.h"
#include "tests/support/temporary_folder.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;
class CoachTest : public MatchClients {
 protected:
  void SetUp() override {
    config_.server.coach_w_referee = true;
    start();
  }

  void start() { MatchClients::start(config_); }

  ClientId player(const std::string& team, const std::string& more = "(version 18)") {
    return connect("(init " + team + " " + more + ")");
  }
  ClientId coach(const std::string& team, const std::string& version = "18") {
    return connect("(init " + team + " (version " + version + "))", ListeningPort::kOnlineCoaches);
  }
  ClientId trainer() { return connect("(init (version 18))", ListeningPort::kTrainers); }

  /// Coach and trainer of a match with a player.
  std::pair<ClientId, ClientId> coach_and_trainer() {
    player("A");
    const ClientId left = coach("A");
    return {left, trainer()};
  }

  MatchConfig config_;
};

TEST_F(CoachTest, AcceptsAnotherCoachAfterFirstDisconnects) {
  player("A");
  const ClientId first = coach("A");
  EXPECT_EQ(coach("A"), kNoClient);
  EXPECT_EQ(answers(first, "(bye)"), Texts{});
  EXPECT_EQ(server_->connection(first), nullptr);
  EXPECT_EQ(coach("A"), first);
  EXPECT_EQ(messages(first).front(), "(init l ok)");
}

// The squares of such numbers are infinite, and results computed from them are NaN.
TEST_F(CoachTest, ClampsTrainerPositionsAndVelocities) {
  player("A");
  const ClientId client = trainer();
  for (const char* order :
       {"(move (ball) 1e308 -1e308 0 1e308 1e308)", "(move (player A 1) 1 1 0 1e308 1e308)",
        "(move (player A 1) 1e308 1e308 0 -1e308 1e308)"}) {
    EXPECT_EQ(answers(client, order), Texts{"(ok move)"});
    for (int i = 0; i < 3; ++i) step();
    const Ball& ball = world().ball;
    const Player& player = world().players[0];
    for (const Vec2 place : {ball.position, ball.velocity, player.position, player.velocity}) {
      EXPECT_TRUE(std::isfinite(place.x) && std::isfinite(place.y)) << order;
    }
  }
}

TEST_F(CoachTest, RefusesTrainerWithoutCoachMode) {
  config_.server.coach_w_referee = false;
  start();
  EXPECT_EQ(
      std::get<soccer::ErrorCode>(server_->admit(ListeningPort::kTrainers, "(init (version 18))")),
      soccer::ErrorCode::kTrainerWithoutCoachMode);
}

TEST_F(CoachTest, SendsSeeGlobalEveryCycleWithEyeOn) {
  const auto [left, offline] = coach_and_trainer();
  answers(left, "(eye on)");
  messages(offline);
  step();
  EXPECT_EQ(messages(left), Texts{"(see_global 0 ((g r) 52.5 0) ((g l) -52.5 0) ((b) 0 0 0 0) "
                                  "((p \"A\" 1) -3 -37 0 0 0 0))"});
  EXPECT_EQ(messages(offline), Texts{});
  answers(left, "(eye off)");
  answers(offline, "(eye on)");
  step();
  EXPECT_EQ(messages(left), Texts{});
  EXPECT_EQ(messages(offline).size(), 1u);
}

// Action marks of a player by client version, and in replies to look.
TEST_F(CoachTest, SendsFewerFieldsToOldVersions) {
  const ClientId kicker = player("A");
  const ClientId offline = trainer();
  answers(offline, "(move (ball) 0.5 0)");
  answers(offline, "(move (player A 1) 0 0)");
  answers(offline, "(change_mode play_on)");
  answers(kicker, "(pointto 10 0)(kick 10 0)");
  const std::string pose = "((p \"A\" 1) 0 0 0 0 0 0";

  const std::pair<const char*, std::string> cases[] = {
      {"8", pose + " 0)"}, {"12", pose + " 0)"}, {"13", pose + " 0 k)"}, {"19", pose + " 0 k)"}};

  for (const auto& [version, seen] : cases) {
    const ClientId watcher = coach("A", version);
    answers(watcher, "(eye on)");
    server_->sense();
    const std::string view = messages(watcher).back();
    EXPECT_THAT(view, HasSubstr(seen)) << version;
    const std::string look = answers(watcher, "(look)").front();
    const bool shows_arm = seen.ends_with("k)");
    EXPECT_THAT(look, HasSubstr(shows_arm ? pose + " 0)" : pose + ")"));
    answers(watcher, "(bye)");
  }
}

TEST_F(CoachTest, SendsThinkOnlyWithEyeOn) {
  const auto [left, offline] = coach_and_trainer();
  answers(left, "(eye on)");
  messages(offline);
  step();
  server_->think();
  EXPECT_EQ(messages(left).back(), "(think)");
  EXPECT_EQ(messages(offline), Texts{});
  EXPECT_TRUE(server_->awaits(left));
  EXPECT_FALSE(server_->awaits(offline));
  server_->receive(left, "(say (freeform \"x\"))(done)");
  EXPECT_TRUE(server_->awaits(left)) << "only the first command of a datagram counts";
  server_->receive(left, "(done)");
  EXPECT_FALSE(server_->awaits(left));
}

TEST_F(CoachTest, LogsCommandsAndTeamGraphics) {
  const auto [left, offline] = coach_and_trainer();
  answers(left,
          "(team_graphic (1 2 \"8 8 1 1\" \"a c #000\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" "
          "\"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\"))");
  answers(offline, "(start)");

  EXPECT_THAT(game_log_.bytes(),
              HasSubstr("(msg 0 1 \"(team_graphic_l (1 2 \"8 8 1 1\" \"a c #000\" "
                        "\"aaaaaaaa\" "));
  EXPECT_EQ(text_log_.bytes().substr(text_log_.bytes().find("Recv A_Coach")),
            "Recv A_Coach: (init A (version 18))\n"
            "0,0\tRecv Coach: (init (version 18))\n"
            "0,0\tRecv A_Coach: (team_graphic (1 2 \"8 8 1 1\" \"a c #000\" \"aaaaaaaa\" "
            "\"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" "
            "\"aaaaaaaa\"))\n"
            "0,0\tRecv Coach: (start)\n"
            "0,0\t(referee kick_off_l)\n");
}

TEST_F(CoachTest, SendsCoachMessageFile) {
  const tests::TemporaryFolder folder;
  config_.server.coach_msg_file = (folder.path() / "words.txt").string();
  std::ofstream(config_.server.coach_msg_file) << "(define x)";
  start();
  player("A");
  EXPECT_EQ(messages(coach("A")).back(), "(include 10 (define x))");
  player("B");
  EXPECT_TRUE(messages(coach("B", "10")).back().starts_with("(player_type "));
}

TEST_F(CoachTest, SendsTeamGraphicsAndGoalieChangesToMonitors) {
  player("A");
  const ClientId left = coach("A");
  const std::string graphic =
      "\"8 8 1 1\" \"a c #000\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" "
      "\"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\" \"aaaaaaaa\"";
  for (int x = 0; x < 32; ++x) {
    answers(left, "(team_graphic (" + std::to_string(x) + " 0 " + graphic + "))");
  }

  answers(left, "(team_graphic (0 1 " + graphic + "))");
  answers(left, "(team_graphic (0 0 " + graphic + "))");
  const ClientId monitor = connect("(dispinit version 4)");
  messages(monitor);
  step();
  Texts received = messages(monitor);
  ASSERT_EQ(received.size(), 33u);
  EXPECT_EQ(received[1], "(msg 0 1 \"(team_graphic_l (0 0 " + graphic + ")\")");

  step();
  received = messages(monitor);
  ASSERT_EQ(received.size(), 2u);
  EXPECT_EQ(received[1], "(msg 0 1 \"(team_graphic_l (0 1 " + graphic + ")\")");

  answers(left, "(change_player_type 1 goalie)");
  EXPECT_EQ(messages(monitor), Texts{"(msg 0 1 \"(change_player_type l 1 goalie)\")"});
}

TEST_F(CoachTest, ExtendsFreeformQuotaAfterEachGame) {
  config_.server.say_coach_cnt_max = 1;
  config_.server.half_time = 1;
  config_.server.nr_extra_halfs = 0;
  start();
  player("A");
  player("B");
  const ClientId left = coach("A");
  const ClientId offline = trainer();
  EXPECT_EQ(answers(left, "(say (freeform \"a\"))"), Texts{"(ok say)"});
  EXPECT_EQ(answers(left, "(say (freeform \"b\"))"),
            Texts{"(error said_too_many_freeform_messages)"});

  while (world().clock.time < 20) {
    if (world().mode == PlayMode::kBeforeKickOff) answers(offline, "(start)");
    step();
  }

  EXPECT_EQ(answers(left, "(say (freeform \"c\"))"), Texts{"(ok say)"});
}

TEST_F(CoachTest, AllowsFreeformOnlyInWindowsOfPlayOn) {
  config_.server.freeform_wait_period = 10;
  config_.server.freeform_send_period = 3;
  config_.server.drop_ball_time = 0;
  start();
  player("A");
  const ClientId left = coach("A");
  answers(trainer(), "(change_mode play_on)");
  std::string allowed;
  for (int time = 0; time <= 34; ++time) {
    allowed += answers(left, "(say (freeform \"a\"))") == Texts{"(ok say)"} ? 'x' : '.';
    step();
  }
  EXPECT_EQ(allowed, "...........xx.......xxx.......xxx..");
}

TEST_F(CoachTest, DelaysMessagesOnlyDuringPlayOn) {
  config_.server.clang_mess_delay = 3;
  config_.server.freeform_wait_period = 1000000;
  start();
  const ClientId listener = player("A");
  answers(listener, "(clang (ver 7 8))");
  const ClientId left = coach("A");
  const ClientId offline = trainer();
  const auto heard = [&] {
    for (const std::string& message : messages(listener)) {
      if (message.find("online_coach") != std::string::npos) return message;
    }
    return std::string();
  };

  EXPECT_EQ(answers(left, "(say (freeform \"now\"))"), Texts{"(ok say)"});
  EXPECT_EQ(heard(), "");
  step();
  EXPECT_EQ(heard(), "(hear 0 online_coach_left (freeform \"now\"))");

  answers(offline, "(change_mode play_on)");
  answers(left, "(say (meta (ver 7)))");
  for (int i = 0; i < 3; ++i) {
    step();
    EXPECT_EQ(heard(), "");
  }
  step();

  EXPECT_EQ(heard(), "(hear 3 online_coach_left (meta (ver 7)))");
}

TEST(LockstepCoaches, AlternateWithPlayers) {
  MatchConfig config;
  config.server.coach_w_referee = true;
  auto server = std::move(*LockstepServer::create(config));
  const auto player = server->connect();
  const auto coach = server->connect(ListeningPort::kOnlineCoaches);
  const auto trainer = server->connect(ListeningPort::kTrainers);
  player->send("(init A (version 18))");
  server->accept_clients();
  coach->send("(init A (version 18))");
  trainer->send("(init (version 18))");
  server->accept_clients();
  coach->send("(eye on)");
  trainer->send("(start)");
  server->run_cycle();

  EXPECT_TRUE(server->awaits(kLeftCoach));
  EXPECT_FALSE(server->awaits(kTrainer));
  EXPECT_EQ(server->world().mode, PlayMode::kKickOffLeft);

  coach->send("(done)");
  EXPECT_FALSE(server->awaits(kLeftCoach));
  server->run_cycle();
  EXPECT_EQ(server->missed_cycles(kLeftCoach), 0);

  server->run_cycle();
  EXPECT_EQ(server->missed_cycles(kLeftCoach), 1);
}

}  // namespace
}  // namespace cls::simulator
