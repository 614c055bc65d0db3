// Socket addresses, UDP sockets and TCP connects on the loopback interface.
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <cerrno>

#include "base/system/socket_address.h"
#include "base/system/tcp_connect.h"
#include "base/system/udp_socket.h"

namespace cls::base {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

TEST(SocketAddress, ParsesIpAddresses) {
  const auto v4 = parse_ip_address("127.0.0.1", 6000);
  const auto v6 = parse_ip_address("::1", 6000);

  ASSERT_TRUE(v4);
  ASSERT_TRUE(v6);
  EXPECT_EQ(v4->port(), 6000);
  EXPECT_EQ(v6->port(), 6000);
  EXPECT_FALSE(v4->same_host(*v6));
  EXPECT_EQ(parse_ip_address("localhost", 6000).error().message, "not an IP address");
  EXPECT_EQ(strip_brackets("[::1]"), "::1");
  EXPECT_EQ(strip_brackets("host"), "host");
}

TEST(SocketAddress, ResolvesUdpHostToIpv4First) {
  const auto found = resolve_udp("localhost", 6000);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->family(), AF_INET);
  EXPECT_FALSE(resolve_udp("no.such.host.invalid", 6000));
}

TEST(UdpSocket, SendsAndReceivesBatches) {
  auto server = UdpSocket::bind(*parse_ip_address("127.0.0.1", 0));
  auto client = UdpSocket::open(AF_INET);
  ASSERT_TRUE(server);
  ASSERT_TRUE(client);
  ASSERT_TRUE(client->connect(*parse_ip_address("127.0.0.1", server->local_port())));

  OutgoingDatagrams outgoing;
  outgoing.add("a", true);
  outgoing.add("bc", false);
  EXPECT_TRUE(outgoing.send(*client));
  EXPECT_TRUE(outgoing.empty());

  IncomingDatagrams incoming;
  ASSERT_EQ(incoming.receive(*server), 0);
  ASSERT_EQ(incoming.size(), 2u);
  EXPECT_EQ(incoming.bytes(0), std::string_view("a\0", 2));
  EXPECT_EQ(incoming.bytes(1), "bc");
  EXPECT_EQ(server->send("reply", false, &incoming.sender(0)), 0);

  std::array<char, 16> buffer;
  std::size_t size = 0;
  SocketAddress sender;
  ASSERT_EQ(client->receive(buffer, size, sender), 0);
  EXPECT_EQ(std::string_view(buffer.data(), size), "reply");
  EXPECT_EQ(sender.port(), server->local_port());
  EXPECT_EQ(client->receive(buffer, size, sender), EAGAIN);
}

TEST(ConnectTcp, ConnectsToListeningPortOnly) {
  const UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  SocketAddress address = *parse_ip_address("127.0.0.1", 0);
  ASSERT_EQ(::bind(listener.get(), address.get(), address.size), 0);
  ASSERT_EQ(::getsockname(listener.get(), address.get(), &address.size), 0);

  const auto deadline = steady_clock::now() + milliseconds(2000);
  EXPECT_FALSE(connect_tcp("127.0.0.1", address.port(), deadline));
  ASSERT_EQ(::listen(listener.get(), 4), 0);
  EXPECT_TRUE(connect_tcp("127.0.0.1", address.port(), deadline));
  EXPECT_FALSE(connect_tcp("no.such.host.invalid", address.port(), deadline));
}

TEST(WaitForEvents, ReturnsFalseAfterDeadline) {
  const auto socket = UdpSocket::bind(*parse_ip_address("127.0.0.1", 0));
  ASSERT_TRUE(socket);
  EXPECT_FALSE(wait_for_events(socket->fd(), POLLIN, steady_clock::now() + milliseconds(1)));
  EXPECT_TRUE(wait_for_events(socket->fd(), POLLOUT, steady_clock::now()));
}

}  // namespace
}  // namespace cls::base
