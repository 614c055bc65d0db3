// Client channels against sockets that reply like a soccer server.
#include "soccer/udp_channel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <optional>
#include <string>
#include <thread>

#include "base/index.h"
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

std::unique_ptr<UdpClients> clients_of(int port, bool on_thread,
                                       const std::string& host = "127.0.0.1") {
  auto made = UdpClients::create(host, port);
  EXPECT_TRUE(made);
  if (on_thread) (*made)->read_on_thread();
  return std::move(*made);
}

/// The next message within two seconds; empty if there is none.
std::string next(UdpClients& clients, Channel& channel) {
  const auto end = steady_clock::now() + std::chrono::seconds(2);
  std::string message;
  while (!channel.receive(message)) {
    if (!clients.wait_until(end)) return "";
  }
  return message;
}

/// A client, the well-known port of its server, and the server's port for it.
class UdpChannelTest : public testing::TestWithParam<bool> {
 protected:
  /// The message of the client reaches the well-known port.
  void reach(const std::string& message = "(init us)") {
    channel_->send(message);
    EXPECT_EQ(listener_.receive(), with_nul(message));
  }
  void answer(ServerSocket& from, const std::string& message) {
    from.send_to(listener_.client(), with_nul(message));
  }
  std::string received() { return next(*clients_, *channel_); }

  void expect_closed() {
    EXPECT_TRUE(clients_->wait_until(steady_clock::now() + std::chrono::seconds(2)));
    std::string message;
    EXPECT_FALSE(channel_->receive(message));
    EXPECT_FALSE(channel_->send("(turn 10)"));
  }

  ServerSocket listener_;
  ServerSocket own_;
  std::unique_ptr<UdpClients> clients_ = clients_of(listener_.port(), GetParam());
  std::unique_ptr<Channel> channel_ = clients_->connect();
};

INSTANTIATE_TEST_SUITE_P(, UdpChannelTest, testing::Bool(),
                         [](const auto& which) { return which.param ? "OnThread" : "OnReceive"; });

TEST_P(UdpChannelTest, AddsAndRemovesNul) {
  EXPECT_TRUE(channel_->send("(init us (version 18))"));
  EXPECT_EQ(listener_.receive(), with_nul("(init us (version 18))"));
  answer(listener_, "(init l 1 before_kick_off)");
  EXPECT_EQ(received(), "(init l 1 before_kick_off)");
}

TEST_P(UdpChannelTest, SwitchesToPortOfReply) {
  reach();
  answer(own_, "(init l 1 before_kick_off)");
  EXPECT_EQ(received(), "(init l 1 before_kick_off)");
  channel_->send("(turn 10)");
  EXPECT_EQ(own_.receive(), with_nul("(turn 10)"));

  answer(listener_, "(error from elsewhere)");
  answer(own_, "(think)");
  EXPECT_EQ(received(), "(think)");
}

// Otherwise they could send to the server in its name.
TEST_P(UdpChannelTest, LeavesItsPortToNoOtherOnAnyAddress) {
  reach();
  answer(own_, "(init l 1 before_kick_off)");
  received();
  channel_->send("(turn 10)");

  const int port = listener_.client().port();
  EXPECT_FALSE(base::UdpSocket::bind(*base::parse_ip_address("127.0.0.2", port)));
}

TEST_P(UdpChannelTest, RetriesAtWellKnownPortAfterRefusal) {
  reach("(reconnect us 3)");
  answer(listener_, "(error cannot_reconnect_while_playon)");
  EXPECT_EQ(received(), "(error cannot_reconnect_while_playon)");

  reach("(reconnect us 3)");
  answer(own_, "(reconnect l goal_l)");
  EXPECT_EQ(received(), "(reconnect l goal_l)");
}

TEST_P(UdpChannelTest, IgnoresMessagesOfOtherHosts) {
  ServerSocket stranger("127.0.0.2");
  reach();
  answer(stranger, "(think)");
  answer(listener_, "(init r 2 play_on)");
  EXPECT_EQ(received(), "(init r 2 play_on)");
}

TEST_P(UdpChannelTest, DetectsClosedServerPort) {
  listener_.close();
  channel_->send("(init us)");
  expect_closed();
}

TEST_P(UdpChannelTest, DetectsServerExit) {
  reach();
  answer(own_, "(init l 1 before_kick_off)");
  received();

  own_.close();
  channel_->send("(turn 10)");
  expect_closed();
}

TEST_P(UdpChannelTest, WaitsUntilDeadline) {
  const auto begin = steady_clock::now();
  EXPECT_FALSE(clients_->wait_until(begin + milliseconds(30)));
  EXPECT_GE(steady_clock::now() - begin, milliseconds(30));
}

TEST_P(UdpChannelTest, ClientsBesideWaitForTheirOwnMessagesOnly) {
  const std::unique_ptr<UdpClients> beside = clients_->beside();
  const std::unique_ptr<Channel> other = beside->connect();
  reach();
  answer(listener_, "(init l 1 before_kick_off)");
  EXPECT_TRUE(clients_->wait_until(steady_clock::now() + std::chrono::seconds(2)));
  EXPECT_FALSE(beside->wait_until(steady_clock::now() + milliseconds(30)));

  other->send("(hello)");
  EXPECT_EQ(listener_.receive(), with_nul("(hello)"));
  answer(listener_, "(error unknown_command)");
  EXPECT_EQ(next(*beside, *other), "(error unknown_command)");
}

TEST_P(UdpChannelTest, SeparatesChannelsAndPreservesOrder) {
  constexpr int kClients = 11;
  constexpr int kMessages = 40;
  ServerSocket listener;
  const auto all = clients_of(listener.port(), GetParam(), "localhost");
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
      EXPECT_EQ(next(*all, *channels[base::index(i)]), std::to_string(100 * i + k));
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
