// UdpServer on loopback sockets, with correct and faulty clients.
#include "simulator/server/udp_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "simulator/server/message_compression.h"
#include "tests/simulator/server/running_server.h"
#include "tests/support/scripted_player.h"
#include "tests/support/udp_client.h"

namespace cls::simulator {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using tests::ScriptedPlayer;
using tests::UdpClient;

std::vector<std::unique_ptr<ScriptedPlayer>> two_teams(int port) {
  std::vector<std::unique_ptr<ScriptedPlayer>> players;
  const auto places = tests::formation(true);
  for (const char* team : {"Left", "Right"}) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      auto& player = *players.emplace_back(
          std::make_unique<ScriptedPlayer>(std::make_unique<UdpClient>(port), team));
      player.stand_at(places[i]);
      player.join(i == 0);
      while (player.unum() == 0) player.act();
    }
  }
  return players;
}

/// The first player of team A or, at the port of coaches, its coach.
class Joined : public UdpClient {
 public:
  explicit Joined(int port, std::string_view reply = "(init l 1 before_kick_off)")
      : UdpClient(port) {
    send("(init A (version 18))");
    if (const std::string answer = wait(); answer != reply) throw std::runtime_error(answer);
  }
};

/// The next message that begins so; what comes before it is dropped. Empty if there is none.
std::string wait_for(UdpClient& client, std::string_view start) {
  std::string message = client.wait();
  while (!message.empty() && !message.starts_with(start)) message = client.wait();
  return message;
}

TEST(UdpServer, PlaysMatchOfTwoTeams) {
  RunningServer running(quick_match());
  auto players = two_teams(running.port);
  while (!running.ended()) {
    for (auto& player : players) player->act();
  }
  EXPECT_EQ(running.wait(), UdpServerExit::kFinished);
  EXPECT_GE(running.server->world().clock.time, 200);  // a stopped clock delays the end
  EXPECT_EQ(running.server->world().mode, PlayMode::kTimeOver);
  EXPECT_EQ(running.server->missed_cycles(), 0);
  EXPECT_THAT(running.text_log.bytes(), HasSubstr("\t(referee kick_off_l)"));
  EXPECT_THAT(running.text_log.bytes(), HasSubstr("\t(referee play_on)"));
  EXPECT_THAT(running.game_log.bytes(), HasSubstr("(result 197001010000 Left_"));
}

TEST(UdpServer, EndsEarlyWhenAllClientsDisconnectAfterTimeOver) {
  UdpConfig config = quick_match();
  config.match.server.game_over_wait = 1000000;
  RunningServer running(config);
  auto players = two_teams(running.port);
  while (!running.ended()) {
    for (auto& player : players) {
      player->act();
      if (player->heard_time_over()) player->send("(bye)");
    }
  }
  EXPECT_EQ(running.wait(), UdpServerExit::kFinished);
}

TEST(UdpServer, RepliesFromNewPortAndKeepsListening) {
  RunningServer running(quick_match());
  Joined client(running.port);
  EXPECT_NE(client.server_port(), running.port);
  client.set_server_port(running.port);
  client.send("(init A (version 18))");
  EXPECT_NE(wait_for(client, "(error only_init_allowed_on_init_port)"), "");
  EXPECT_NE(client.server_port(), running.port);
}

TEST(UdpServer, SendsErrorsFromListeningPort) {
  RunningServer running(quick_match());
  UdpClient client(running.port);
  for (const auto& [request, answer] :
       {std::pair{"(dash 100)", "(error unknown_command)"},
        {"(init A (version 99))", "(error no_more_player_or_goalie_or_illegal_client_version)"},
        {"(init)", "(error unknown_command)"},
        {"", "(error unknown_command)"}}) {
    client.send(request);
    EXPECT_EQ(client.wait(), answer) << request;
    EXPECT_EQ(client.server_port(), running.port);
  }
}

TEST(UdpServer, AcceptsRequestsWithLineFeedAndWithoutNul) {
  RunningServer running(quick_match());
  UdpClient client(running.port);
  client.send_bytes("(init A (version 18))\n");
  EXPECT_EQ(client.wait(), "(init l 1 before_kick_off)");
}

TEST(UdpServer, WarnsOfDatagramsWithoutNul) {
  RunningServer running(quick_match());
  Joined client(running.port);
  client.send_bytes("(score)");
  client.send("(done)");
  bool warned = false;
  for (std::string message = client.wait(); !message.empty(); message = client.wait()) {
    warned = warned || message == "(warning message_not_null_terminated)";
    if (message.starts_with("(score")) break;
  }
  EXPECT_TRUE(warned);
}

TEST(UdpServer, IgnoresGarbage) {
  RunningServer running(quick_match());
  UdpClient garbage(running.port);
  std::string bytes(8000, '\xff');
  for (int i = 0; i < 200; ++i) {
    garbage.send_bytes(bytes.substr(0, static_cast<std::size_t>(i * 40)));
    garbage.send_bytes(std::string(static_cast<std::size_t>(i), '('));
  }

  // Garbage may have filled the server's buffer: the client repeats its request until it gets a
  // reply.
  UdpClient client(running.port);
  std::string message;
  for (int i = 0; i < 100 && message.empty(); ++i) {
    client.send("(init A (version 18))");
    message = client.wait(milliseconds(20));
  }

  EXPECT_EQ(message, "(init l 1 before_kick_off)");
  client.send_bytes(bytes);
  client.send_bytes(std::string("(turn 1)\0(turn 2)", 17));
  client.send("(say \"abc\")(done)");

  EXPECT_EQ(wait_for(client, "(hear 0 self"), "(hear 0 self \"abc\")");
}

TEST(UdpServer, RemovesClientWithClosedSocket) {
  UdpConfig config = quick_match();
  config.max_wait = milliseconds(50);
  RunningServer running(config);
  { Joined client(running.port); }
  // Sending to the closed port fails, and the next cycle runs without the player.
  ScriptedPlayer witness(std::make_unique<UdpClient>(running.port), "A");
  witness.join();
  for (int cycles = 0; cycles < 10; cycles += witness.act() ? 1 : 0) {
  }
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
  EXPECT_TRUE(running.server->world().player(Side::kLeft, 1).joined);
  EXPECT_FALSE(running.server->world().player(Side::kLeft, 1).enabled);
}

TEST(UdpServer, ContinuesWithoutUnresponsiveClientAndEndsAfterMaxMissed) {
  UdpConfig config = quick_match();
  config.match.server.connect_wait = 3;
  config.max_wait = milliseconds(2);
  config.max_missed = 10;
  RunningServer running(config);
  UdpClient client(running.port);
  client.send("(init A (version 18))");
  EXPECT_EQ(running.wait(), UdpServerExit::kUnresponsiveClients);
  EXPECT_EQ(running.server->world().clock.time, 11);
  EXPECT_EQ(running.server->missed_cycles(), 11) << "none before the start";
}

TEST(UdpServer, ErrorNamesPortInUse) {
  RunningServer running(quick_match());
  UdpConfig config = quick_match();
  config.port = running.port;
  const auto second = UdpServer::open(config);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message, "cannot listen on 127.0.0.1 port " +
                                        std::to_string(running.port) + ": Address already in use");
}

TEST(UdpServer, ErrorNamesInvalidAddress) {
  UdpConfig config = quick_match();
  config.address = "localhorst";
  const auto server = UdpServer::open(config);
  ASSERT_FALSE(server);
  EXPECT_EQ(server.error().message, "cannot listen on localhorst port 0: not an IP address");
}

using Clock = std::chrono::steady_clock;

TEST(UdpServer, StepsInRealTime) {
  RunningServer running(real_time_match());
  Joined client(running.port);
  int senses = 0;
  const auto begin = Clock::now();
  while (senses < 40) senses += client.wait().starts_with("(sense_body 0 ") ? 1 : 0;
  const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  EXPECT_GT(ms, 39 * 20 - 5.0);
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
  // A loaded host may be late, but cycles are never shorter.
  const StepTimer::Lateness lateness = running.server->lateness();
  EXPECT_GE(lateness.steps, 40);
  EXPECT_GE(lateness.worst_ms, lateness.mean_ms);
}

TEST(UdpServer, SendsNoThinkInRealTime) {
  RunningServer running(real_time_match());
  UdpClient client(running.port);
  client.send("(init A (version 18))");
  bool received = false;
  for (int senses = 0; senses < 10;) {
    const std::string message = client.wait();
    ASSERT_FALSE(message.empty());
    EXPECT_NE(message, "(think)");
    if (message.starts_with("(server_param")) {
      received = message.find("(synch_mode 0)") != std::string::npos;
    }
    senses += message.starts_with("(sense_body") ? 1 : 0;
  }

  EXPECT_TRUE(received);
}

TEST(UdpServer, ExecutesCommandsWithoutDoneInRealTime) {
  RunningServer running(real_time_match());
  Joined client(running.port);
  client.send("(turn 90)(score)");
  std::string message = wait_for(client, "(score");
  EXPECT_EQ(message, "(score 0 0 0)");
  while (!message.empty() && message.find("(turn 1)") == std::string::npos) message = client.wait();
  EXPECT_TRUE(message.starts_with("(sense_body 0 ")) << message;
}

TEST(UdpServer, IsNotDelayedByUnresponsiveClientInRealTime) {
  UdpConfig config = real_time_match();
  config.match.server.connect_wait = 2;
  config.match.server.game_over_wait = 2;
  RunningServer running(config);
  UdpClient client(running.port);
  client.send("(init A (version 18))");
  EXPECT_EQ(running.wait(), UdpServerExit::kFinished);
  EXPECT_EQ(running.server->world().mode, PlayMode::kTimeOver);
}

// Without synch_see, see messages with normal view are due every send_step, independent of the
// cycle.
TEST(UdpServer, SendsSeeAtSendStepInRealTime) {
  UdpConfig config = real_time_match();
  config.match.server.simulator_step = 100;
  config.match.server.sense_body_step = 100;
  config.match.server.send_step = 150;
  RunningServer running(config);
  UdpClient client(running.port);
  client.send("(init A (version 14))");
  int senses = 0;
  int sees = 0;

  while (senses < 16) {
    const std::string message = client.wait();
    ASSERT_FALSE(message.empty());
    if (senses > 0 && message.starts_with("(see ")) ++sees;
    if (message.starts_with("(sense_body")) ++senses;
  }

  EXPECT_EQ(sees, 10);  // in 15 cycles
}

TEST(UdpServer, LetsMonitorWatchAndStartMatch) {
  UdpConfig config = real_time_match();
  config.match.server.auto_mode = false;
  RunningServer running(config);
  UdpClient monitor(running.port);
  monitor.send("(dispinit version 5)");
  EXPECT_TRUE(monitor.wait().starts_with("(server_param "));
  EXPECT_NE(monitor.server_port(), running.port);
  EXPECT_NE(wait_for(monitor, "(show 0 (pm 1) "), "");
  monitor.send("(dispstart)");
  EXPECT_NE(wait_for(monitor, "(show 3 (pm 4) "), "");
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
}

TEST(UdpServer, DoesNotWaitForClientsThatSentBye) {
  UdpConfig config = quick_match();
  config.max_wait = std::chrono::hours(1);
  RunningServer running(config);
  Joined player(running.port);
  UdpClient coach(running.server->port(ListeningPort::kOnlineCoaches));
  while (!coach.wait(milliseconds(20)).starts_with("(init l")) coach.send("(init A (version 18))");
  coach.send("(eye on)");
  player.send("(bye)");
  coach.send("(bye)");
  UdpClient witness(running.port);
  witness.send("(init B (version 18))");
  std::string message;

  for (int thinks = 0; thinks < 3; thinks += message == "(think)" ? 1 : 0) {
    ASSERT_FALSE((message = witness.wait()).empty());
    if (message == "(think)") witness.send("(done)");
  }

  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
}

// A cycle's (think) goes to those who got its senses: a player that joins while the server waits
// for others would have to decide without having seen anything.
TEST(UdpServer, SendsThinkOnlyAfterSenses) {
  UdpConfig config = quick_match();
  config.pause_before_start = milliseconds(30);
  RunningServer running(config);

  for (int i = 0; i < 8; ++i) {
    UdpClient player(running.port);
    player.send("(init A (version 18))");
    ASSERT_THAT(player.wait(), HasSubstr("(init l "));
    std::string first;
    while (first.empty()) {
      const std::string message = player.wait();
      ASSERT_FALSE(message.empty());
      if (message == "(think)" || message.starts_with("(sense_body")) first = message;
    }
    EXPECT_THAT(first, HasSubstr("(sense_body"));
    player.send("(bye)");
  }
}

TEST(UdpServer, SendsThinkToCoachOnlyAfterItsView) {
  UdpConfig config = quick_match();
  config.pause_before_start = milliseconds(30);
  RunningServer running(config);
  Joined player(running.port);
  Joined coach(running.server->port(ListeningPort::kOnlineCoaches), "(init l ok)");
  coach.send("(eye on)");
  std::string first;

  while (first != "(think)" && !first.starts_with("(see_global")) {
    std::string message;
    while (player.receive(message)) {
      if (message == "(think)") player.send("(done)");
    }
    if (coach.receive(message)) first = message;
  }

  EXPECT_THAT(first, HasSubstr("(see_global"));
}

// A client that waits for the reply before its (done) must not cost the match a stall.
TEST(UdpServer, AnswersOnReceiptInSynchronousMode) {
  UdpConfig config = quick_match();
  config.max_wait = std::chrono::hours(1);
  RunningServer running(config);
  Joined player(running.port);
  ASSERT_NE(wait_for(player, "(think)"), "");

  for (const auto& [command, answer] : {std::pair{"(clang (ver 7 8))", "(ok clang (ver 7 8))"},
                                        {"(score)", "(score 0 0 0)"},
                                        {"(nonsense)", "(error illegal_command_form)"},
                                        {"(sense_body)", "(sense_body 0 "}}) {
    player.send(command);
    EXPECT_THAT(player.wait(), HasSubstr(answer)) << command;
  }
  player.send("(turn 10)");
  player.send("(score)");  // after the turn
  EXPECT_EQ(player.wait(milliseconds(50)), "");

  Joined coach(running.server->port(ListeningPort::kOnlineCoaches), "(init l ok)");
  for (std::string message; message != "(ok eye on)";) {
    coach.send("(eye on)");
    ASSERT_FALSE((message = coach.wait()).empty());
  }
  coach.send("(team_names)");

  EXPECT_THAT(coach.wait(), HasSubstr("ok "));
}

// rcssserver sends (think) to all clients together; a slow coach has received the messages of the
// cycle before it decides.
TEST(UdpServer, SendsThinkToCoachesLateInSomeCycles) {
  RunningServer running(quick_match());
  Joined player(running.port);
  Joined coach(running.server->port(ListeningPort::kOnlineCoaches), "(init l ok)");
  coach.send("(eye on)");
  std::string cycle;
  std::map<std::string, int> orders;

  for (int views = 0; views < 150;) {
    std::string message;
    while (player.receive(message)) {
      if (message == "(think)") player.send("(say \"abc\")(done)");
    }
    if (!coach.receive(message)) continue;
    if (message.starts_with("(see_global") && ++views > 10) {
      ++orders[cycle];
      cycle.clear();
    }
    if (message == "(think)") coach.send("(done)");
    if (views >= 10 && message != "(ok eye on)") cycle += message.substr(0, 5) + " ";
  }

  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
  const int late = orders["(see_ (hear (thin "];

  EXPECT_EQ(orders["(see_ (thin (hear "] + late, 140);
  EXPECT_GT(late, 0);
  EXPECT_LT(late, 30);
}

TEST(UdpServer, ListensForCoachesAndTrainerOnSeparatePorts) {
  UdpConfig config = quick_match();
  config.match.server.coach_w_referee = true;
  RunningServer running(config);
  UdpClient trainer(running.server->port(ListeningPort::kTrainers));
  trainer.send("(init (version 18))");
  EXPECT_EQ(trainer.wait(), "(init ok)");

  Joined player(running.port);
  const int coach_port = running.server->port(ListeningPort::kOnlineCoaches);
  UdpClient coach(coach_port);
  coach.send("(init A Cch (version 18))");
  EXPECT_EQ(coach.wait(), "(init l ok)");
  EXPECT_NE(coach.server_port(), coach_port);

  UdpClient second(coach_port);
  second.send("(init A (version 18))");
  EXPECT_EQ(second.wait(), "(error already_have_coach)");
  EXPECT_EQ(second.server_port(), coach_port);
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
  EXPECT_EQ(running.server->coach_name(Side::kLeft), "Cch");
}

// Like rcssserver: the reply is uncompressed, then every message is a zlib stream.
TEST(UdpServer, CompressesBothDirectionsOnRequest) {
  RunningServer running(real_time_match());
  Joined client(running.port);
  client.send("(compression 6)");
  EXPECT_EQ(wait_for(client, "(ok compression"), "(ok compression 6)");
  MessageCompression stream(6);
  client.send_bytes(stream.compress(std::string("(score)\0", 8)));
  std::string plain;
  while (!plain.starts_with("(score")) {
    const std::string bytes = client.wait_bytes();
    ASSERT_FALSE(bytes.empty());
    ASSERT_TRUE(stream.decompress(bytes, 8192, plain)) << bytes.size();
    ASSERT_EQ(plain.back(), '\0');
  }

  EXPECT_EQ(plain.substr(0, plain.size() - 1), "(score 0 0 0)");
}

TEST(MessageCompression, DecompressesLikeRcssserver) {
  MessageCompression stream(9);
  const std::string text(3000, 'x');
  const std::string compressed(stream.compress(text));
  EXPECT_LT(compressed.size(), 100u);
  EXPECT_EQ(compressed.substr(compressed.size() - 4), std::string("\0\0\xff\xff", 4));
  std::string plain;
  EXPECT_TRUE(stream.decompress(compressed, 8192, plain));
  EXPECT_EQ(plain, text);
  EXPECT_FALSE(stream.decompress(compressed, 100, plain));  // decompression bomb
  EXPECT_FALSE(stream.decompress("(turn 10)", 8192, plain));
  EXPECT_TRUE(stream.decompress(compressed, 8192, plain));  // still usable
}

}  // namespace
}  // namespace cls::simulator
