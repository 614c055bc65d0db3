// A client's channel against sockets that answer as a soccer server does.
#include "soccer/udp_channel.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>

namespace cls::soccer {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// A bound socket of the server's: a well-known port, or one of its own for a client.
class Door {
 public:
  explicit Door(const char* host = "127.0.0.1") : fd_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in any{};
    any.sin_family = AF_INET;
    ::inet_pton(AF_INET, host, &any.sin_addr);
    EXPECT_EQ(::bind(fd_, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
    socklen_t size = sizeof any;
    ::getsockname(fd_, reinterpret_cast<sockaddr*>(&any), &size);
    port_ = ntohs(any.sin_port);
  }
  ~Door() { close(); }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

  int port() const { return port_; }

  /// What came, NUL and all; empty when nothing comes within a second.
  std::string receive() {
    pollfd ready{fd_, POLLIN, 0};
    if (::poll(&ready, 1, 1000) != 1) return "";
    std::array<char, 9000> buffer;
    socklen_t size = sizeof client_;
    const ssize_t count = ::recvfrom(fd_, buffer.data(), buffer.size(), 0,
                                     reinterpret_cast<sockaddr*>(&client_), &size);
    return {buffer.data(), static_cast<std::size_t>(count)};
  }

  void send_to(const sockaddr_in& client, const std::string& bytes) {
    ::sendto(fd_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&client),
             sizeof client);
  }

  const sockaddr_in& client() const { return client_; }

 private:
  int fd_;
  int port_ = 0;
  sockaddr_in client_{};
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

/// The next message within two seconds; empty when none comes.
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

TEST_P(UdpChannelTest, EndsMessagesWithNulAndStripsIt) {
  Door door;
  const auto all = clients(door.port());
  const auto channel = all->connect();
  EXPECT_TRUE(channel->send("(init us (version 18))"));
  EXPECT_EQ(door.receive(), with_nul("(init us (version 18))"));
  door.send_to(door.client(), with_nul("(init l 1 before_kick_off)"));
  EXPECT_EQ(next(*all, *channel), "(init l 1 before_kick_off)");
}

TEST_P(UdpChannelTest, StaysWithThePortThatAnswered) {
  Door door;
  Door own;
  const auto all = clients(door.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  door.receive();
  own.send_to(door.client(), with_nul("(init l 1 before_kick_off)"));
  EXPECT_EQ(next(*all, *channel), "(init l 1 before_kick_off)");
  channel->send("(turn 10)");
  EXPECT_EQ(own.receive(), with_nul("(turn 10)"));

  door.send_to(door.client(), with_nul("(error from elsewhere)"));
  own.send_to(door.client(), with_nul("(think)"));
  EXPECT_EQ(next(*all, *channel), "(think)");
}

TEST_P(UdpChannelTest, AsksAgainAtTheWellKnownPortAfterARefusal) {
  Door door;
  Door own;
  const auto all = clients(door.port());
  const auto channel = all->connect();
  channel->send("(reconnect us 3)");
  door.receive();
  door.send_to(door.client(), with_nul("(error cannot_reconnect_while_playon)"));
  EXPECT_EQ(next(*all, *channel), "(error cannot_reconnect_while_playon)");
  channel->send("(reconnect us 3)");
  EXPECT_EQ(door.receive(), with_nul("(reconnect us 3)"));
  own.send_to(door.client(), with_nul("(reconnect l goal_l)"));
  EXPECT_EQ(next(*all, *channel), "(reconnect l goal_l)");
}

TEST_P(UdpChannelTest, DoesNotListenToStrangers) {
  Door door;
  Door stranger("127.0.0.2");
  const auto all = clients(door.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  door.receive();
  stranger.send_to(door.client(), with_nul("(think)"));
  door.send_to(door.client(), with_nul("(init r 2 play_on)"));
  EXPECT_EQ(next(*all, *channel), "(init r 2 play_on)");
}

TEST_P(UdpChannelTest, KnowsThatNobodyIsThere) {
  int port = 0;
  {
    const Door door;
    port = door.port();
  }
  const auto all = clients(port);
  const auto channel = all->connect();
  channel->send("(init us)");
  EXPECT_TRUE(all->wait_until(steady_clock::now() + std::chrono::seconds(2)));
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_FALSE(channel->send("(init us)"));
}

TEST_P(UdpChannelTest, KnowsThatTheServerHasGone) {
  Door door;
  Door own;
  const auto all = clients(door.port());
  const auto channel = all->connect();
  channel->send("(init us)");
  door.receive();
  own.send_to(door.client(), with_nul("(init l 1 before_kick_off)"));
  next(*all, *channel);
  own.close();
  channel->send("(turn 10)");
  EXPECT_TRUE(all->wait_until(steady_clock::now() + std::chrono::seconds(2)));
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_FALSE(channel->send("(turn 10)"));
}

TEST_P(UdpChannelTest, WaitsNoLongerThanAsked) {
  Door door;
  const auto all = clients(door.port());
  const auto channel = all->connect();
  const auto begin = steady_clock::now();
  EXPECT_FALSE(all->wait_until(begin + milliseconds(30)));
  EXPECT_GE(steady_clock::now() - begin, milliseconds(30));
}

TEST_P(UdpChannelTest, KeepsTheMessagesOfManyChannelsApartAndInOrder) {
  constexpr int kClients = 11;
  constexpr int kMessages = 40;
  Door door;
  const auto all = clients(door.port(), "localhost");
  std::vector<std::unique_ptr<Channel>> channels;
  for (int i = 0; i < kClients; ++i) {
    channels.push_back(all->connect());
    channels.back()->send("(init us)");
    door.receive();
    for (int k = 0; k < kMessages; ++k) {
      door.send_to(door.client(), with_nul(std::to_string(100 * i + k)));
    }
  }
  for (int i = 0; i < kClients; ++i) {
    for (int k = 0; k < kMessages; ++k) {
      EXPECT_EQ(next(*all, *channels[static_cast<std::size_t>(i)]), std::to_string(100 * i + k));
    }
  }
}

TEST(UdpChannelOnThread, NotesWhenMessagesCameNotWhenTheyWereTaken) {
  Door door;
  const auto made = UdpClients::create("127.0.0.1", door.port());
  (*made)->read_on_thread();
  const auto channel = (*made)->connect();
  channel->send("(init us)");
  door.receive();
  const auto sent = steady_clock::now();
  door.send_to(door.client(), with_nul("(think)"));
  ASSERT_TRUE((*made)->wait_until(sent + std::chrono::seconds(2)));
  const auto noticed = steady_clock::now();
  std::this_thread::sleep_for(milliseconds(20));
  std::string message;
  ASSERT_TRUE(channel->receive(message));
  EXPECT_GE(channel->arrived(), sent);
  EXPECT_LE(channel->arrived(), noticed);
}

TEST(UdpChannelOnThread, ChannelsMayOutliveTheReader) {
  Door door;
  auto made = UdpClients::create("127.0.0.1", door.port());
  (*made)->read_on_thread();
  const auto channel = (*made)->connect();
  made->reset();
  std::string message;
  EXPECT_FALSE(channel->receive(message));
  EXPECT_TRUE(channel->send("(bye)"));
  EXPECT_EQ(door.receive(), with_nul("(bye)"));
}

TEST(UdpClientsCreate, NamesTheHostThatDoesNotExist) {
  const auto made = UdpClients::create("no.such.host.invalid", 6000);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("no.such.host.invalid"), std::string::npos);
}

}  // namespace
}  // namespace cls::soccer
