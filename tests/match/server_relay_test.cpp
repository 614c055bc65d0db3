// A relay between two ports of this host, before a server that these tests play.
#include "match/server/server_relay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "base/system/time_slice.h"
#include "tests/support/udp_client.h"

namespace cls::match {
namespace {

using base::SocketAddress;
using base::UdpSocket;
using soccer::Side;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::chrono::milliseconds kSilence{150};

SocketAddress loopback(int port) { return *base::parse_ip_address("127.0.0.1", port); }

/// The next datagram without its NUL; empty if none comes.
std::string received(UdpSocket& socket, SocketAddress& sender,
                     std::chrono::milliseconds longest = std::chrono::seconds(10)) {
  pollfd ready{socket.fd(), POLLIN, 0};
  if (::poll(&ready, 1, static_cast<int>(longest.count())) != 1) return {};
  std::array<char, 9000> buffer;
  std::size_t size = 0;
  if (socket.receive(buffer, size, sender) != 0) return {};
  return std::string(buffer.data(), size).c_str();
}

std::string received(UdpSocket& socket) {
  SocketAddress sender;
  return received(socket, sender);
}

/// A socket of a server, and who has sent to it last.
class ServerSocket {
 public:
  ServerSocket() : socket_(*UdpSocket::bind(loopback(0))) {}
  int port() const { return socket_.local_port(); }

  /// The next datagram without its NUL; empty if none comes.
  std::string wait(std::chrono::milliseconds longest = std::chrono::seconds(10)) {
    return received(socket_, peer_, longest);
  }
  void send(std::string_view message) { socket_.send(message, true, &peer_); }
  void send_to(const SocketAddress& peer, std::string_view message) {
    peer_ = peer;
    send(message);
  }
  const SocketAddress& peer() const { return peer_; }

 private:
  UdpSocket socket_;
  SocketAddress peer_;
};

int free_port() { return UdpSocket::bind(loopback(0))->local_port(); }

class ServerRelayTest : public testing::Test {
 protected:
  ServerRelayTest() {
    RelayRoute route{Side::kLeft,           &UdpSocket::bind,          loopback(player_port_),
                     loopback(coach_port_), loopback(players_.port()), loopback(coaches_.port())};
    auto relay = ServerRelay::create(std::move(route), names_);
    if (!relay) throw std::runtime_error(relay.error().message);
    relay_ = *std::move(relay);
  }

  /// A client whose request the server has answered from a port of its own.
  void connect(tests::UdpClient& client, ServerSocket& own, const std::string& request) {
    client.send(request);
    EXPECT_EQ(players_.wait(), request);
    own.send_to(players_.peer(), "(init l 1 before_kick_off)");
    EXPECT_EQ(client.wait(), "(init l 1 before_kick_off)");
  }

  void expect_refusal(int port, const std::string& request, const std::string& reply) {
    tests::UdpClient client(port);
    client.send(request);
    EXPECT_EQ(client.wait(), reply) << request;
  }

  const int player_port_ = free_port();
  const int coach_port_ = free_port();
  ServerSocket players_;
  ServerSocket coaches_;
  ClaimedNames names_;
  std::unique_ptr<ServerRelay> relay_;
};

TEST_F(ServerRelayTest, GivesEachClientPortsOfItsOwn) {
  tests::UdpClient first(player_port_);
  tests::UdpClient second(player_port_);
  ServerSocket first_own;
  ServerSocket second_own;
  connect(first, first_own, "(init Lions (version 18) (goalie))");
  connect(second, second_own, "(init Lions (version 18))");
  EXPECT_NE(first.server_port(), player_port_);
  EXPECT_NE(first.server_port(), second.server_port());

  first.send("(turn 10)(done)");
  second.send("(dash 50)(done)");
  EXPECT_EQ(first_own.wait(), "(turn 10)(done)");
  EXPECT_EQ(second_own.wait(), "(dash 50)(done)");
  for (int cycle = 1; cycle <= 100; ++cycle) {
    const std::string message = "(think " + std::to_string(cycle) + ")";
    second_own.send(message);
    ASSERT_EQ(second.wait(), message);
  }
  EXPECT_THAT(relay_->take_warnings(), IsEmpty());
}

TEST_F(ServerRelayTest, PassesErrorsFromThePortOfTheServer) {
  tests::UdpClient client(player_port_);
  client.send("(init Lions (version 99))");
  EXPECT_EQ(players_.wait(), "(init Lions (version 99))");
  players_.send("(error no_more_player_or_goalie_or_illegal_client_version)");
  EXPECT_EQ(client.wait(), "(error no_more_player_or_goalie_or_illegal_client_version)");
  EXPECT_EQ(client.server_port(), player_port_);
}

TEST_F(ServerRelayTest, PassesTheCoachOfTheSide) {
  tests::UdpClient player(player_port_);
  ServerSocket own;
  connect(player, own, "(init Lions (version 18))");
  tests::UdpClient coach(coach_port_);
  ServerSocket coach_own;

  coach.send("(init Lions Mary (version 18))");
  EXPECT_EQ(coaches_.wait(), "(init Lions Mary (version 18))");
  coach_own.send_to(coaches_.peer(), "(init l ok)");
  EXPECT_EQ(coach.wait(), "(init l ok)");
  coach.send("(eye on)");
  EXPECT_EQ(coach_own.wait(), "(eye on)");
}

// Monitors watch, and send players off: (dispcard), (dispfoul). On the usual server one port serves
// players and monitors.
TEST_F(ServerRelayTest, RefusesMonitorsOnEachPort) {
  for (const char* request : {"(dispinit)", "(dispinit version 4)", " ( dispinit version -1 )"}) {
    expect_refusal(player_port_, request, "(error no_more_monitor)");
  }
  for (const char* request : {"(dispinit version inf)", "(dispcard 1 2 red)", "(start)", "xyz"}) {
    expect_refusal(player_port_, request, "(error unknown_command)");
  }
  for (const char* request : {"(dispinit)", "(init (version 18))", "(change_mode play_on)"}) {
    expect_refusal(coach_port_, request, "(error illegal_command_form)");
  }
  EXPECT_EQ(players_.wait(kSilence), "");
  EXPECT_EQ(coaches_.wait(kSilence), "");
  EXPECT_THAT(relay_->take_warnings(), Each(HasSubstr("a program of the left side at UDP port ")));
}

// A server that has forgotten a player would take its port for that of a new monitor.
TEST_F(ServerRelayTest, RefusesMonitorsAtThePortsOfPlayers) {
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 18))");
  for (const char* request : {"(dispinit)", "(dispinit version inf)", " (dispinit version 0x4)"}) {
    client.set_server_port(player_port_);
    client.send(request);
    EXPECT_THAT(client.wait(), HasSubstr("(error ")) << request;
  }
  EXPECT_EQ(players_.wait(kSilence), "");
}

TEST_F(ServerRelayTest, RefusesTheNamesOfTheOtherSide) {
  EXPECT_TRUE(names_.claim(Side::kRight, "Bears"));
  expect_refusal(player_port_, "(init Bears (version 18))", "(error no_more_team)");
  EXPECT_TRUE(names_.collided(Side::kLeft));
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 18))");

  expect_refusal(player_port_, "(init Tigers (version 18))", "(error no_more_team)");
  expect_refusal(player_port_, "(reconnect Bears 2)", "(error no_such_team_or_player)");
  expect_refusal(coach_port_, "(init Bears Eve (version 18))", "(error no_such_team)");
  EXPECT_EQ(players_.wait(kSilence), "");
  EXPECT_EQ(coaches_.wait(kSilence), "");
  EXPECT_EQ(relay_->take_warnings().size(), 2U) << "one for each kind of request";
}

// The server reads up to the first NUL.
TEST_F(ServerRelayTest, PassesNothingBehindARequest) {
  tests::UdpClient client(player_port_);
  client.send_bytes(std::string("(init Lions (version 18))\0(dispinit)", 36));
  EXPECT_EQ(players_.wait(), "(init Lions (version 18))");
  expect_refusal(player_port_, std::string("\0(init Lions)", 13), "(error unknown_command)");
}

TEST_F(ServerRelayTest, PassesAReconnectionToANewPort) {
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 18))");
  const int port = client.server_port();

  client.set_server_port(player_port_);
  client.send("(reconnect Lions 1)");
  EXPECT_EQ(players_.wait(), "(reconnect Lions 1)");
  ServerSocket again;
  again.send_to(players_.peer(), "(reconnect l before_kick_off)");
  EXPECT_EQ(client.wait(), "(reconnect l before_kick_off)");
  EXPECT_NE(client.server_port(), port);
  client.send("(turn 1)");
  EXPECT_EQ(again.wait(), "(turn 1)");
}

// Players of versions before 8 send all commands to the port of the server.
TEST_F(ServerRelayTest, PassesCommandsOfOldClientsAtThePortOfTheServer) {
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 7))");
  client.set_server_port(player_port_);
  client.send("(dash 100)");
  EXPECT_EQ(players_.wait(), "(dash 100)");
  EXPECT_EQ(players_.peer().port(), own.peer().port());
}

TEST_F(ServerRelayTest, AcceptsNoMessagesOfOtherPortsThanThoseOfTheServer) {
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 18))");
  ServerSocket forger;
  forger.send_to(own.peer(), "(hear 100 referee goal_l_9)");
  own.send("(hear 100 referee kick_off_l)");
  EXPECT_EQ(client.wait(), "(hear 100 referee kick_off_l)");
}

// A server that takes the socket has the client at its own end; the relay passes nothing more.
TEST_F(ServerRelayTest, HandsClientsOverToTheServer) {
  tests::UdpClient client(player_port_);
  client.send("(init Lions (version 18))");
  EXPECT_EQ(players_.wait(), "(init Lions (version 18))");
  const auto elsewhere = base::parse_ip_address("127.0.0.2", players_.peer().port());
  EXPECT_FALSE(relay_->hand_over(*elsewhere));
  auto direct = relay_->hand_over(players_.peer());
  ASSERT_TRUE(direct);
  EXPECT_FALSE(relay_->hand_over(players_.peer())) << "again for the same request";

  direct->send("(init l 1 before_kick_off)", true);
  EXPECT_EQ(client.wait(), "(init l 1 before_kick_off)");
  EXPECT_EQ(client.server_port(), direct->local_port());
  client.send("(turn 10)");
  EXPECT_EQ(received(*direct), "(turn 10)");
  EXPECT_FALSE(relay_->hand_over(loopback(free_port())));
}

// The server knows them by the address of the relay, which passes all that they send.
TEST_F(ServerRelayTest, KeepsClientsThatSendToThePortOfTheServer) {
  tests::UdpClient client(player_port_);
  for (const char* request : {"(init Lions (version 7))", "(init Lions)", "(reconnect Lions 1)"}) {
    client.set_server_port(player_port_);
    client.send(request);
    EXPECT_EQ(players_.wait(), request);
    EXPECT_FALSE(relay_->hand_over(players_.peer())) << request;
  }
}

TEST_F(ServerRelayTest, HandsTheCoachOver) {
  EXPECT_TRUE(names_.claim(Side::kLeft, "Lions"));
  tests::UdpClient coach(coach_port_);
  coach.send("(init Lions Mary (version 18))");
  EXPECT_EQ(coaches_.wait(), "(init Lions Mary (version 18))");
  const auto direct = relay_->hand_over(coaches_.peer());
  ASSERT_TRUE(direct);
  coach.send("(init Lions (version 5))");
  EXPECT_EQ(coaches_.wait(), "(init Lions (version 5))");
  EXPECT_FALSE(relay_->hand_over(coaches_.peer()));
}

bool is_free(int port) { return static_cast<bool>(UdpSocket::bind(loopback(port))); }

// A server learns of a lost client, and a client of the end of a server, by a closed port.
TEST_F(ServerRelayTest, ClosesPortsWithTheirPeers) {
  auto client = std::make_unique<tests::UdpClient>(player_port_);
  auto own = std::make_unique<ServerSocket>();
  connect(*client, *own, "(init Lions (version 18))");
  const int outside = own->peer().port();
  EXPECT_FALSE(is_free(outside));
  client.reset();
  for (int i = 0; i < 500 && !is_free(outside); ++i) {
    own->send("(sense_body 1)");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(is_free(outside));

  client = std::make_unique<tests::UdpClient>(player_port_);
  connect(*client, *own, "(init Lions (version 18))");
  const int inside = client->server_port();
  EXPECT_FALSE(is_free(inside));
  own.reset();
  for (int i = 0; i < 500 && !is_free(inside); ++i) {
    client->send("(turn 1)");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(is_free(inside));
}

// Requests without end leave room for those of the team.
TEST_F(ServerRelayTest, HoldsAsManyClientsAsATeamNeeds) {
  tests::UdpClient client(player_port_);
  ServerSocket own;
  connect(client, own, "(init Lions (version 18))");
  std::vector<std::unique_ptr<tests::UdpClient>> others;
  for (int i = 0; i < 200; ++i) {
    others.push_back(std::make_unique<tests::UdpClient>(player_port_));
    others.back()->send("(init Lions (version 18))");
    ASSERT_EQ(players_.wait(), "(init Lions (version 18))");
  }

  tests::UdpClient last(player_port_);
  ServerSocket last_own;
  connect(last, last_own, "(init Lions (version 18))");
  own.send("(think)");
  EXPECT_EQ(client.wait(), "(think)");
}

// Otherwise each datagram waits for programs that compute: a match on a busy host took twice as
// long.
TEST_F(ServerRelayTest, RunsBeforeProgramsThatCompute) {
  if (base::time_slice_of(0).count() == 0) GTEST_SKIP() << "this kernel has no slices of threads";
  bool found = false;
  for (int i = 0; i < 500 && !found; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
      const auto slice = base::time_slice_of(std::stoi(thread.path().filename()));
      found = found || slice == std::chrono::microseconds(100);
    }
  }
  EXPECT_TRUE(found);
}

TEST_F(ServerRelayTest, EndsWithItsPorts) {
  relay_.reset();
  EXPECT_TRUE(UdpSocket::bind(loopback(player_port_)));
  EXPECT_TRUE(UdpSocket::bind(loopback(coach_port_)));
}

TEST_F(ServerRelayTest, NamesAPortThatItCannotOpen) {
  RelayRoute route{Side::kRight,          &UdpSocket::bind,          loopback(free_port()),
                   loopback(coach_port_), loopback(players_.port()), loopback(coaches_.port())};
  const auto second = ServerRelay::create(std::move(route), names_);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            "port " + std::to_string(coach_port_) + ": Address already in use");
}

}  // namespace
}  // namespace cls::match
