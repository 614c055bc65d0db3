// Client channels against sockets that reply like a soccer server.
#include "soccer/udp_channel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <optional>
#include <string>
#include <thread>

#include "base/system/udp_socket.h"

namespace cls::soccer {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;

/// A server socket: the well-known port, or the port for one client.
class ServerSocket {
 public:
  explicit ServerSocket(const char* host = "127.0.0.1")
      : socket_(*base::UdpSocket::bind(*base::parse_ip_address(host, 0))),
        port_(socket_->local_port()) {}
  void close() { socket_.reset(); }

  int port() const { return port_; }

  /// The received datagram with its NUL; empty if none arrives within a second.
  std::string receive() {
    pollfd ready{socket_->fd(), POLLIN, 0};
    if (::poll(&ready, 1, 1000) != 1) return "";
    std::array<char, 9000> buffer;
    std::size_t size = 0;
    EXPECT_EQ(socket_->receive(buffer, size, client_), 0);
    return {buffer.data(), size};
  }

  void send_to(const base::SocketAddress& client, const std::string& bytes) {
    EXPECT_EQ(socket_->send(bytes, false, &client), 0);
  }

  const base::SocketAddress& client() const { return client_; }

 private:
  std::optional<base::UdpSocket> socket_;
  int port_;
  base::SocketAddress client_;
};

std::string with_nul(std::string text) { return text + '\0'; }

class UdpChannelTest : public testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<UdpClients> clients(int port, const std::string& host = "127.0.0.1") {
    auto made = UdpClients::create(host, port);
    EXPECT_TRUE(made);
    if (GetParam()) (*made)->read_on_thread();
    return std::move(*made);
  }
};

/// The next message within two seconds; empty if there is none.
std::string next(UdpClients& clients, Channel& channel) {
  const auto end = steady_clock::now() + std::chrono::seconds(2);
  std::string message;
  while (!channel.receive(message)) {
    if (!clients.wait_until(end)) return "";
  }
  return message;
}

INSTANTIATE_TEST_SUITE_P(, UdpChannelTest, testing::Bool(),
                         [](const auto& which) { return which.param ? "OnThread" : "OnReceive"; });

TEST_P(UdpChannelTest, AddsAndRemovesNul) {
  ServerSocket listener;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  EXPECT_TRUE(channel->send("(init us (version 18))"));
  EXPECT_EQ(listener.receive(), with_nul("(init us (version 18))"));
  listener.send_to(listener.client(), with_nul("(init l 1 before_kick_off)"));
  EXPECT_EQ(next(*all, *channel), "(init l 1 before_kick_off)");
}

TEST_P(UdpChannelTest, SwitchesToPortOfReply) {
  ServerSocket listener;
  ServerSocket own;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  listener.receive();
  own.send_to(listener.client(), with_nul("(init l 1 before_kick_off)"));
  EXPECT_EQ(next(*all, *channel), "(init l 1 before_kick_off)");
  channel->send("(turn 10)");
  EXPECT_EQ(own.receive(), with_nul("(turn 10)"));

  listener.send_to(listener.client(), with_nul("(error from elsewhere)"));
  own.send_to(listener.client(), with_nul("(think)"));
  EXPECT_EQ(next(*all, *channel), "(think)");
}

// Otherwise they could send to the server in its name.
TEST_P(UdpChannelTest, LeavesItsPortToNoOtherOnAnyAddress) {
  ServerSocket listener;
  ServerSocket own;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  listener.receive();
  own.send_to(listener.client(), with_nul("(init l 1 before_kick_off)"));
  next(*all, *channel);
  channel->send("(turn 10)");
  const int port = listener.client().port();
  EXPECT_FALSE(base::UdpSocket::bind(*base::parse_ip_address("127.0.0.2", port)));
}

TEST_P(UdpChannelTest, RetriesAtWellKnownPortAfterRefusal) {
  ServerSocket listener;
  ServerSocket own;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  channel->send("(reconnect us 3)");
  listener.receive();
  listener.send_to(listener.client(), with_nul("(error cannot_reconnect_while_playon)"));
  EXPECT_EQ(next(*all, *channel), "(error cannot_reconnect_while_playon)");
  channel->send("(reconnect us 3)");
  EXPECT_EQ(listener.receive(), with_nul("(reconnect us 3)"));
  own.send_to(listener.client(), with_nul("(reconnect l goal_l)"));
  EXPECT_EQ(next(*all, *channel), "(reconnect l goal_l)");
}

TEST_P(UdpChannelTest, IgnoresMessagesOfOtherHosts) {
  ServerSocket listener;
  ServerSocket stranger("127.0.0.2");
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  listener.receive();
  stranger.send_to(listener.client(), with_nul("(think)"));
  listener.send_to(listener.client(), with_nul("(init r 2 play_on)"));
  EXPECT_EQ(next(*all, *channel), "(init r 2 play_on)");
}

TEST_P(UdpChannelTest, DetectsClosedServerPort) {
  int port = 0;
  {
    const ServerSocket listener;
    port = listener.port();
  }
  const auto all = clients(port);
  const auto channel = all->connect();
  channel->send("(init us)");
  EXPECT_TRUE(all->wait_until(steady_clock::now() + std::chrono::seconds(2)));
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_FALSE(channel->send("(init us)"));
}

TEST_P(UdpChannelTest, DetectsServerExit) {
  ServerSocket listener;
  ServerSocket own;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  listener.receive();
  own.send_to(listener.client(), with_nul("(init l 1 before_kick_off)"));
  next(*all, *channel);
  own.close();
  channel->send("(turn 10)");
  EXPECT_TRUE(all->wait_until(steady_clock::now() + std::chrono::seconds(2)));
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_FALSE(channel->send("(turn 10)"));
}

TEST_P(UdpChannelTest, WaitsUntilDeadline) {
  ServerSocket listener;
  const auto all = clients(listener.port());
  const auto channel = all->connect();
  const auto begin = steady_clock::now();
  EXPECT_FALSE(all->wait_until(begin + milliseconds(30)));
  EXPECT_GE(steady_clock::now() - begin, milliseconds(30));
}

TEST_P(UdpChannelTest, SeparatesChannelsAndPreservesOrder) {
  constexpr int kClients = 11;
  constexpr int kMessages = 40;
  ServerSocket listener;
  const auto all = clients(listener.port(), "localhost");
  std::vector<std::unique_ptr<Channel>> channels;
  for (int i = 0; i < kClients; ++i) {
    channels.push_back(all->connect());
    channels.back()->send("(init us)");
    listener.receive();
    for (int k = 0; k < kMessages; ++k) {
      listener.send_to(listener.client(), with_nul(std::to_string(100 * i + k)));
    }
  }
  for (int i = 0; i < kClients; ++i) {
    for (int k = 0; k < kMessages; ++k) {
      EXPECT_EQ(next(*all, *channels[static_cast<std::size_t>(i)]), std::to_string(100 * i + k));
    }
  }
}

TEST(UdpChannelOnThread, RecordsArrivalTimesOfMessages) {
  ServerSocket listener;
  const auto made = UdpClients::create("127.0.0.1", listener.port());
  (*made)->read_on_thread();
  const auto channel = (*made)->connect();
  channel->send("(init us)");
  listener.receive();
  const auto sent = steady_clock::now();
  listener.send_to(listener.client(), with_nul("(think)"));
  ASSERT_TRUE((*made)->wait_until(sent + std::chrono::seconds(2)));
  const auto noticed = steady_clock::now();
  std::this_thread::sleep_for(milliseconds(20));
  std::string message;
  ASSERT_TRUE(channel->receive(message));
  EXPECT_GE(channel->received_at(), sent);
  EXPECT_LE(channel->received_at(), noticed);
}

TEST(UdpChannelOnThread, ChannelsOutliveReader) {
  ServerSocket listener;
  auto made = UdpClients::create("127.0.0.1", listener.port());
  (*made)->read_on_thread();
  const auto channel = (*made)->connect();
  made->reset();
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_TRUE(channel->send("(bye)"));
  EXPECT_EQ(listener.receive(), with_nul("(bye)"));
}

TEST(UdpClients, ReportsUnknownHost) {
  const auto made = UdpClients::create("no.such.host.invalid", 6000);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("no.such.host.invalid"));
}

}  // namespace
}  // namespace cls::soccer
