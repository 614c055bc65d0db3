// Teams on the embedded server over UDP, synchronous and in real time.
#include "proxy/agent/team_driver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <optional>
#include <thread>

#include "base/io/byte_sink.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "simulator/server/udp_server.h"
#include "tests/proxy/agent/scripted_server.h"
#include "tests/proxy/playmaker/fake_playmaker.h"
#include "tests/support/udp_client.h"

namespace cls::proxy {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;
using testing::Not;
using tests::FakePlaymaker;
using tests::ScriptedServer;

simulator::UdpConfig short_match(int cycles) {
  simulator::UdpConfig config;
  config.port = 0;
  config.match.seed = 7;
  config.match.cycle_limit = cycles;
  config.match.server.synch_mode = true;
  config.match.server.auto_mode = true;
  config.match.server.kick_off_wait = 3;
  config.match.server.connect_wait = 1000000;
  config.match.server.game_over_wait = 3;
  config.pause_before_start = milliseconds(1);
  return config;
}

/// The embedded server on its own thread.
struct Server {
  explicit Server(const simulator::UdpConfig& config)
      : udp(std::move(*simulator::UdpServer::open(config))), port(udp->port()) {
    thread = std::thread([this] { end = udp->run(stop); });
  }
  ~Server() {
    stop = true;
    wait();
  }
  void wait() {
    if (thread.joinable()) thread.join();
  }

  std::unique_ptr<simulator::UdpServer> udp;
  int port;
  std::atomic<bool> stop{false};
  simulator::UdpServerExit end = simulator::UdpServerExit::kStopped;
  std::thread thread;
};

/// A team with a bundled mock on its own thread.
struct Side {
  Side(const char* name, int port, bool on_thread, DriverOptions driving = quick())
      : mock(std::move(
            *mock_server::Server::start(std::move(*mock_server::make_behavior("simple"))))),
        playmaker(make_grpc_playmaker(mock->in_process_channel(), "mock")),
        clients(std::move(*soccer::UdpClients::create("127.0.0.1", port))),
        team(options(name), *playmaker),
        driver(team, *clients, std::move(driving)) {
    if (on_thread) clients->read_on_thread();
  }

  static TeamOptions options(const char* name) {
    TeamOptions options;
    options.name = name;
    return options;
  }
  static DriverOptions quick() {
    DriverOptions options;
    options.server_timeout = milliseconds(1500);
    return options;
  }

  void join(const ShouldContinue& go_on) {
    const auto connected = driver.connect(go_on);
    ASSERT_TRUE(connected) << connected.error().message;
  }
  void play(const ShouldContinue& go_on) {
    thread = std::thread([this, go_on] {
      const RpcStatus introduced = team.register_agents();
      EXPECT_TRUE(introduced.ok()) << introduced.message;
      end = driver.run(go_on);
      team.leave();
    });
  }

  std::unique_ptr<mock_server::Server> mock;
  std::unique_ptr<Playmaker> playmaker;
  std::unique_ptr<soccer::UdpClients> clients;
  Team team;
  TeamDriver driver;
  DriveResult end = DriveResult::kStopped;
  std::thread thread;
};

class UdpMatch : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, UdpMatch, testing::Bool(),
                         [](const auto& which) { return which.param ? "OnThread" : "OnReceive"; });

TEST_P(UdpMatch, PlaysInSynchronousModeWithoutMissedCycle) {
  constexpr int kCycles = 120;
  simulator::UdpConfig config = short_match(kCycles);
  config.max_wait = std::chrono::seconds(20);  // tolerates a busy host
  Server server(config);
  const auto limit = steady_clock::now() + std::chrono::seconds(60);
  const ShouldContinue go_on = [limit] { return steady_clock::now() < limit; };
  Side left("left", server.port, GetParam());
  Side right("right", server.port, GetParam());

  ASSERT_TRUE(wait_for_server(*left.clients, go_on));
  left.join(go_on);
  left.play(go_on);
  right.join(go_on);
  right.play(go_on);
  left.thread.join();
  right.thread.join();
  server.wait();

  EXPECT_EQ(server.end, simulator::UdpServerExit::kFinished);
  EXPECT_EQ(server.udp->world().clock.time, kCycles);
  EXPECT_EQ(server.udp->missed_cycles(), 0);

  for (const Side* side : {&left, &right}) {
    ASSERT_EQ(side->team.players().size(), 11U);
    for (const auto& player : side->team.players()) {
      EXPECT_GE(player->statistics().decisions, kCycles);
      EXPECT_EQ(player->statistics().missed, 0);
      EXPECT_EQ(player->statistics().undecided, 0);
      EXPECT_EQ(player->statistics().lost_commands, 0);
      EXPECT_EQ(player->server().errors.unreadable, 0);
      EXPECT_EQ(player->server().errors.errors, 0) << player->server().errors.first_error;
      EXPECT_EQ(player->server().errors.warnings, 0) << player->server().errors.first_warning;
    }
  }
}

TEST(WaitForServer, ReturnsWhenServerStarts) {
  int port = 0;
  { port = Server(short_match(1)).port; }
  auto clients = std::move(*soccer::UdpClients::create("127.0.0.1", port));
  const auto start = steady_clock::now();
  EXPECT_FALSE(wait_for_server(
      *clients, [start] { return steady_clock::now() - start < milliseconds(150); }));
  simulator::UdpConfig config = short_match(1);
  config.port = port;
  const Server server(config);
  const auto limit = steady_clock::now() + std::chrono::seconds(20);
  EXPECT_TRUE(wait_for_server(*clients, [limit] { return steady_clock::now() < limit; }));
}

TEST(TeamDriver, EndsWhenServerStopsSending) {
  Server server(short_match(100000));
  const auto limit = steady_clock::now() + std::chrono::seconds(30);
  const ShouldContinue go_on = [limit] { return steady_clock::now() < limit; };
  Side left("left", server.port, false);
  left.join(go_on);
  left.play(go_on);
  server.stop = true;
  server.wait();
  left.thread.join();
  EXPECT_EQ(left.end, DriveResult::kServerUnresponsive);
}

// A match that has ended waits for the thread of its agents.
TEST(TeamDriver, StopsWaitingForASilentPortOfCoaches) {
  const Server server(short_match(100000));
  auto silent = std::move(*base::UdpSocket::bind(*base::parse_ip_address("127.0.0.1", 0)));
  std::optional<steady_clock::time_point> asked;
  const ShouldContinue go_on = [&] {
    std::array<char, 100> bytes;
    std::size_t size = 0;
    base::SocketAddress sender;
    if (!asked && silent.receive(bytes, size, sender) == 0) asked = steady_clock::now();
    return !asked;
  };

  DriverOptions driving = Side::quick();
  driving.coach_port = silent.local_port();
  Side left("left", server.port, false, driving);
  left.join(go_on);
  ASSERT_TRUE(asked);
  EXPECT_LT(steady_clock::now() - *asked, milliseconds(1000));
}

// A client of the same host may reconnect as a player that is connected, before the kick-off.
TEST(TeamDriver, EndsWhenOthersTakeOverItsPlayers) {
  simulator::UdpConfig config = short_match(100000);
  config.max_wait = milliseconds(100);
  Server server(config);
  const auto limit = steady_clock::now() + std::chrono::seconds(30);
  const ShouldContinue go_on = [limit] { return steady_clock::now() < limit; };
  DriverOptions driving = Side::quick();
  driving.coach_port = server.udp->port(simulator::ListeningPort::kOnlineCoaches);
  Side left("left", server.port, false, driving);
  left.join(go_on);
  left.play(go_on);

  std::vector<std::unique_ptr<tests::UdpClient>> others;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    others.push_back(std::make_unique<tests::UdpClient>(server.port));
    others.back()->send("(reconnect left " + std::to_string(unum) + ")");
    EXPECT_TRUE(others.back()->wait().starts_with("(reconnect l before_kick_off)"));
  }

  left.thread.join();
  EXPECT_EQ(left.end, DriveResult::kPlayersUnheard);
}

TEST(RealTime, DecidesOnSeeWithoutThinkAndSendsNoDone) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const protos::State&, protos::PlayerActions& actions) {
    actions.add_actions()->mutable_turn()->set_relative_direction(30);
    return RpcStatus{};
  };
  ScriptedServer server;
  server.synchronous = false;
  TeamOptions options;
  options.name = "us";
  Team team(options, playmaker);
  server.admit(team);
  server.send_cycle(1, false);

  EXPECT_EQ(team.begin_decisions(steady_clock::now()), 11);
  EXPECT_EQ(team.outstanding(), 11);
  EXPECT_EQ(team.begin_decisions(steady_clock::now()), 0);
  while (team.handle_reply(milliseconds(1))) {
  }
  EXPECT_EQ(team.outstanding(), 0);
  server.serve();

  for (int unum = 1; unum <= 11; ++unum) {
    const auto said = server.take(unum);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_THAT(said[0], HasSubstr("(turn 30)"));
    EXPECT_THAT(said[0], Not(HasSubstr("(done)")));
  }

  // The counters of the next sense_body do not move: the turns came too late.
  server.send_cycle(2, false);

  EXPECT_EQ(team.begin_decisions(steady_clock::now()), 11);
  EXPECT_EQ(team.players().front()->statistics().lost_commands, 1);
}

}  // namespace
}  // namespace cls::proxy
