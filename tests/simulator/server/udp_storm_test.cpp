// Load tests of UdpServer: floods, reconnecting clients, restarts, concurrent servers.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "simulator/server/message_compression.h"
#include "tests/simulator/server/running_server.h"
#include "tests/support/scripted_player.h"
#include "tests/support/udp_client.h"

namespace cls::simulator {
namespace {

using std::chrono::milliseconds;
using tests::ScriptedPlayer;
using tests::UdpClient;

/// Plays during a flood; the messages that it receives show whether the flood affects it.
class Witness {
 public:
  explicit Witness(int port) : player_(std::make_unique<UdpClient>(port), "Witness") {
    player_.join();
    while (player_.unum() == 0) player_.act();
  }

  /// Plays so many cycles.
  void play(int cycles) {
    for (int played = 0; played < cycles; played += player_.act() ? 1 : 0) {
    }
  }

 private:
  ScriptedPlayer player_;
};

/// A thread that calls `send` until the end of the scope, after `start`.
class Flood {
 public:
  template <typename Start, typename Send>
  Flood(int port, Start start, Send send) {
    thread_ = std::thread([this, port, start, send] {
      UdpClient client(port);
      start(client);
      while (!stop_) send(client);
    });
  }
  ~Flood() {
    stop_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

void join_flood(UdpClient& client) {
  client.send("(init Flood (version 18))");
  while (!client.wait().starts_with("(ok synch_see)")) {
  }
}

UdpConfig endless() {
  UdpConfig config = quick_match();
  config.pause_before_start = milliseconds(1);
  config.max_wait = milliseconds(20);  // most clients here never send (done)
  return config;
}

TEST(UdpStorm, SurvivesHundredRestarts) {
  for (int i = 0; i < 100; ++i) {
    RunningServer running(endless());
    UdpClient client(running.port);
    client.send("(init A (version 18))");
    ASSERT_EQ(client.wait(), "(init l 1 before_kick_off)") << i;
    UdpClient monitor(running.port);
    monitor.send("(dispinit version 5)");
    ASSERT_TRUE(monitor.wait().starts_with("(server_param ")) << i;
    ASSERT_EQ(running.stop(), UdpServerExit::kStopped);
  }
}

TEST(UdpStorm, RunsManyServersConcurrently) {
  std::vector<std::unique_ptr<RunningServer>> servers;
  for (int i = 0; i < 10; ++i) servers.push_back(std::make_unique<RunningServer>(endless()));
  for (const auto& server : servers) Witness(server->port).play(2);
  for (const auto& server : servers) EXPECT_EQ(server->stop(), UdpServerExit::kStopped);
}

TEST(UdpStorm, SurvivesMonitorsThatConnectAndDisconnect) {
  RunningServer running(endless());
  Witness witness(running.port);

  for (int round = 0; round < 10; ++round) {
    std::vector<std::unique_ptr<UdpClient>> crowd;
    for (int i = 0; i < 30; ++i) {
      crowd.push_back(std::make_unique<UdpClient>(running.port));
      crowd.back()->send("(dispinit version " + std::to_string(3 + i % 3) + ")");
    }
    witness.play(2);
    // A third of the clients sends bye, the others only close their sockets.
    for (int i = 0; i < 30; i += 3) {
      auto& client = *crowd[static_cast<std::size_t>(i)];
      client.wait();
      client.send("(dispbye)");
    }
    witness.play(2);
  }
  UdpClient last(running.port);
  last.send("(dispinit version 5)");

  EXPECT_TRUE(last.wait().starts_with("(server_param "));
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
}

TEST(UdpStorm, SurvivesPlayersThatConnectAndDisconnect) {
  RunningServer running(endless());
  Witness witness(running.port);
  int taken = 0;
  for (int i = 0; i < 40; ++i) {
    UdpClient client(running.port);
    client.send(i % 2 == 0 ? "(init Storm (version 18))" : "(init Witness (version 14))");
    if (client.wait().starts_with("(init")) ++taken;
    if (i % 3 == 0) client.send("(bye)");
    // Some clients closed their sockets; the server notices with the next message to them.
    witness.play(1);
  }

  EXPECT_EQ(taken, 21);  // and the witness
  UdpClient back(running.port);
  back.send("(reconnect Storm 3)");

  EXPECT_EQ(back.wait(), "(reconnect r before_kick_off)");
}

/// A server with a witness, which a flood of commands must not delay.
template <typename Start, typename Send>
void expect_no_delay(Start start, Send send) {
  UdpConfig config = endless();
  config.max_wait = milliseconds(2000);
  RunningServer running(config);
  Witness witness(running.port);
  std::chrono::steady_clock::duration needed{};

  {
    const Flood flood(running.port, start, send);
    const auto begin = std::chrono::steady_clock::now();
    witness.play(50);
    needed = std::chrono::steady_clock::now() - begin;
  }

  EXPECT_LT(needed, std::chrono::seconds(20));
  EXPECT_EQ(running.stop(), UdpServerExit::kStopped);
  EXPECT_GT(running.server->world().player(Side::kRight, 1).counters.turn, 0);
}

// Exceeds the receive quota of a client; its (done) is recognized anyway.
TEST(UdpStorm, FloodOfOneClientDelaysNoOtherClient) {
  expect_no_delay(join_flood,
                  [](UdpClient& client) { client.send("(turn 10)(say \"abc\")(done)"); });
}

// The datagrams of a client that compresses cost the server a hundred times their size.
TEST(UdpStorm, CompressedFloodDelaysNoOtherClient) {
  MessageCompression zlib(9);
  std::string turns;
  while (turns.size() < 8000) turns += "(turn 10)";
  const std::string datagram(zlib.compress(turns));
  ASSERT_LT(datagram.size(), 100u);

  const auto start = [](UdpClient& client) {
    join_flood(client);
    client.send("(compression 9)");
    client.wait_bytes();
  };
  // It never sends (done), and never has to: it floods the server.
  expect_no_delay(start, [&](UdpClient& client) { client.send_bytes(datagram); });
}

// Receives up to so many sense_body messages, or fewer if the server stops sending.
int count_senses(UdpClient& client, int most) {
  int senses = 0;
  while (senses < most) {
    const std::string message = client.wait();
    if (message.empty()) break;
    senses += message.starts_with("(sense_body") ? 1 : 0;
  }
  return senses;
}

/// A server in real time whose client must receive its senses during a flood.
template <typename Start, typename Send>
void expect_senses(Start start, Send send, const RunningServer::Prepare& prepare = {}) {
  RunningServer running(real_time_match(), prepare);
  UdpClient client(running.port);
  client.send("(init A (version 18))");
  ASSERT_EQ(client.wait(), "(init l 1 before_kick_off)");
  const Flood flood(running.port, start, send);
  EXPECT_EQ(count_senses(client, 20), 20);
}

// Each of these datagrams causes work a thousand times its size.
TEST(UdpStorm, FloodOfRequestsDelaysNoClient) {
  for (const std::string request : {"(sense_body)", "(say \"abc\")", "(clang (ver 7 8))"}) {
    SCOPED_TRACE(request);
    std::string datagram;
    while (datagram.size() < 8000) datagram += request;
    const auto start = [](UdpClient& other) {
      other.send("(init A (version 18))");
      other.wait();
    };
    expect_senses(start, [&](UdpClient& other) { other.send(datagram); });
  }
}

TEST(UdpStorm, FloodOnListeningPortDelaysNoClient) {
  expect_senses([](UdpClient&) {}, [](UdpClient& stranger) { stranger.send("(dash 100)"); });
}

/// A server that looks for the process of each sender of a request for so long.
RunningServer::Prepare looking_for(milliseconds time) {
  return [time](UdpServer& server) {
    const auto look = [time](const base::SocketAddress&) {
      std::this_thread::sleep_for(time);
      return ClientRights{};
    };
    server.bind_clients(look, {});
  };
}

// The sender of each request is a process among many.
TEST(UdpStorm, FloodOfRequestsToBecomeAClientDelaysNoClient) {
  expect_senses([](UdpClient&) {}, [](UdpClient& stranger) { stranger.send("(reconnect A 7)"); },
                looking_for(milliseconds(5)));
}

// As if the host had stalled while the server looked for the sender's process.
TEST(UdpStorm, AnswersRequestsSoonAfterAStall) {
  const RunningServer running(quick_match(), looking_for(milliseconds(700)));
  UdpClient client(running.port);
  client.send("(hello)");
  ASSERT_NE(client.wait(), "");
  const auto begin = std::chrono::steady_clock::now();
  client.send("(hello)");
  ASSERT_NE(client.wait(), "");
  // At most half a second of rest, and another stall; four stalls of rest would be 2.8 s.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(2500));
}

}  // namespace
}  // namespace cls::simulator
