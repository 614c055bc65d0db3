// A program that connects a UDP socket, and gets another one.
#include "process/connection_trap.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/utsname.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/process/test_guard.h"
#include "tests/support/built.h"

namespace cls::process {
namespace {

using base::UdpSocket;

class ConnectionTrapTest : public testing::Test {
 protected:
  ConnectionTrapTest() {
    auto created = ConnectionTrap::create([this](const base::SocketAddress& peer) {
      ++asked_;
      return peer.port() == asked_port_ ? connected_to(other_) : std::nullopt;
    });
    if (created) trap_ = *std::move(created);
  }

  void SetUp() override {
    utsname system{};
    int major = 0;
    int minor = 0;
    ::uname(&system);
    std::sscanf(system.release, "%d.%d", &major, &minor);
    if (std::pair(major, minor) < std::pair(5, 19)) GTEST_SKIP() << "needs Linux 5.19";
  }

  static UdpSocket bound() { return *UdpSocket::bind(*base::parse_ip_address("127.0.0.1", 0)); }

  static std::optional<UdpSocket> connected_to(const UdpSocket& peer) {
    auto socket = bound();
    socket.connect(*base::parse_ip_address("127.0.0.1", peer.local_port()));
    return socket;
  }

  /// Empty if none comes.
  static std::string received(UdpSocket& socket) {
    pollfd ready{socket.fd(), POLLIN, 0};
    std::array<char, 100> buffer;
    std::size_t size = 0;
    base::SocketAddress sender;
    if (::poll(&ready, 1, 2000) != 1 || socket.receive(buffer, size, sender) != 0) return {};
    return {buffer.data(), size};
  }

  CommandPlan trapped(CommandPlan plan) const {
    trap_->add_to(plan);
    return plan;
  }

  UdpSocket asked_for_ = bound();
  UdpSocket other_ = bound();
  const int asked_port_ = asked_for_.local_port();
  const std::string port_ = std::to_string(asked_port_);
  std::atomic<int> asked_ = 0;
  std::unique_ptr<ConnectionTrap> trap_;
  MarkedHost processes_;
};

TEST_F(ConnectionTrapTest, PutsAnotherSocketInPlaceOfTheOneThatConnects) {
  const auto child = processes_.start(trapped(fake({"send-udp", port_, "hello"})));
  EXPECT_EQ(received(other_), "hello");
  EXPECT_TRUE(saw_line(*child, "sent"));
  EXPECT_EQ(asked_, 1);
}

TEST_F(ConnectionTrapTest, LeavesOtherConnectionsAsTheyAre) {
  auto third = bound();
  const std::string port = std::to_string(third.local_port());
  const auto child = processes_.start(trapped(fake({"send-udp", port, "hello"})));
  EXPECT_EQ(received(third), "hello");
  EXPECT_EQ(asked_, 1);
}

TEST_F(ConnectionTrapTest, StandsForProgramsThatAProgramBecomes) {
  const std::string program = tests::built("cls_fake_process");
  const auto child = processes_.start(trapped(fake({"exec", program, "send-udp", port_, "hello"})));
  EXPECT_EQ(received(other_), "hello");
}

TEST_F(ConnectionTrapTest, LeavesNoDescriptorToTheProgram) {
  const auto child = processes_.start(trapped(fake({"print-fds"})));
  EXPECT_TRUE(saw_line(*child, "fds: 0 1 2"));
}

TEST_F(ConnectionTrapTest, EndsBeforeTheProgram) {
  const auto child = processes_.start(
      trapped(fake({"sleep", "0.5", "send-udp", port_, "hello", "print", "after"})));
  trap_.reset();
  EXPECT_TRUE(saw_line(*child, "after"));
}

}  // namespace
}  // namespace cls::process
