// Owners of UDP sockets: programs, daemons of theirs, this process, others, and those that hide.
#include "process/socket_owner.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/system/udp_socket.h"
#include "process/ports.h"
#include "process/socket_visibility.h"
#include "tests/process/test_guard.h"
#include "tests/support/built.h"
#include "tests/support/command.h"

namespace cls::process {
namespace {

using testing::Contains;
using Kind = SocketOwner::Kind;

base::SocketAddress loopback(int port) { return *base::parse_ip_address("127.0.0.1", port); }

class SocketOwnersTest : public testing::Test {
 protected:
  SocketOwnersTest() {
    auto reserved = ReservedPort::choose(1);
    reserved_.emplace(std::move(reserved->front()));
    port_ = reserved_->number();
    text_ = std::to_string(port_);
  }

  /// A program of this name that has printed "open", and may have left that to a daemon.
  std::shared_ptr<Child> start(const std::string& name, std::vector<std::string> actions) {
    CommandPlan plan = fake(std::move(actions));
    plan.name = name;
    auto child = processes_.start(plan);
    for (int i = 0; i < 500 && !testing::Value(child->last_lines(), Contains("open")); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_THAT(child->last_lines(), Contains("open"));
    return child;
  }
  SocketOwner owner() { return owners_.owner_of(loopback(port_)); }

  MarkedHost processes_;
  SocketOwners owners_ = SocketOwners::of_own_programs();
  std::optional<ReservedPort> reserved_;
  int port_ = 0;
  std::string text_;
};

TEST_F(SocketOwnersTest, KnowPrograms) {
  const auto child = start("left player 7", {"bind-udp", text_, "print", "open", "hang"});
  const SocketOwner found = owner();
  EXPECT_EQ(found.kind, Kind::kProgram);
  EXPECT_TRUE(found.program.starts_with("left player")) << found.program;
  EXPECT_EQ(found.pid, child->status().pid);
}

TEST_F(SocketOwnersTest, KnowDaemonsOfPrograms) {
  const auto child = start("right team", {"in-orphan", "bind-udp", text_, "print", "open", "hang"});
  EXPECT_EQ(owner().kind, Kind::kProgram);
  EXPECT_TRUE(owner().program.starts_with("right team")) << owner().program;
}

TEST_F(SocketOwnersTest, KnowTheStarter) {
  EXPECT_EQ(owner().kind, Kind::kUnknown) << "no socket";
  const auto own = base::UdpSocket::bind(loopback(port_));
  EXPECT_EQ(owner().kind, Kind::kStarter);
  EXPECT_EQ(owner().pid, ::getpid());
}

TEST_F(SocketOwnersTest, KnowProcessesOutside) {
  const auto started = tests::run({tests::built("cls_fake_process"), "in-orphan", "bind-udp", text_,
                                   "print", "open", "sleep", "60"});
  SocketOwner found;
  for (int i = 0; i < 100 && found.pid == 0; ++i) {
    found = owner();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(found.kind, Kind::kOutside);
  ASSERT_GT(found.pid, 1);

  ::kill(found.pid, SIGKILL);
}

// A process that a program of the match started by other ways than its guard could be any side's.
TEST_F(SocketOwnersTest, DoNotKnowOtherChildrenOfTheStarter) {
  tests::Command child(
      {tests::built("cls_fake_process"), "bind-udp", text_, "print", "open", "hang"});
  ASSERT_TRUE(child.wait_for_output("open"));
  EXPECT_EQ(owner().kind, Kind::kUnknown);
}

TEST_F(SocketOwnersTest, DoNotKnowASocketThatIsHidden) {
  const auto child = start("left team", {"hide-udp", text_, "hang"});
  EXPECT_EQ(owner().kind, Kind::kUnknown);
}

TEST_F(SocketOwnersTest, DoNotKnowASocketOfTwoPrograms) {
  const auto one = start("left team", {"share-udp", text_, "print", "open", "hang"});
  EXPECT_EQ(owner().kind, Kind::kProgram);
  const auto other = start("right team", {"share-udp", text_, "print", "open", "hang"});
  EXPECT_EQ(owner().kind, Kind::kUnknown);
}

// A program can send from any address of the host (IP_PKTINFO), whatever its socket is bound to.
TEST_F(SocketOwnersTest, DoNotKnowAPortThatAnotherHasOnAnotherAddress) {
  const auto program = start("left team", {"bind-udp", text_, "print", "open", "hang"});
  EXPECT_EQ(owner().kind, Kind::kProgram);
  const auto beside = base::UdpSocket::bind(*base::parse_ip_address("127.0.0.2", port_));
  ASSERT_TRUE(beside);
  EXPECT_EQ(owner().kind, Kind::kUnknown);
}

TEST_F(SocketOwnersTest, CanBeSeenHere) { EXPECT_EQ(missing_socket_owners(), ""); }

TEST_F(SocketOwnersTest, IgnoreNamesThatProgramsGiveThemselves) {
  const auto child = start(
      "left team", {"exec", "/bin/sh", "-c",
                    "echo 'of right team' > /proc/$$/comm; " + tests::built("cls_fake_process") +
                        " bind-udp " + text_ + " print open hang"});
  EXPECT_TRUE(owner().program.starts_with("left team")) << owner().program;
}

TEST_F(SocketOwnersTest, KnowPeersOfAServer) {
  auto server = base::UdpSocket::bind(loopback(0));
  ASSERT_TRUE(server->connect(loopback(port_)));
  const auto child = start("left team", {"bind-udp", text_, "print", "open", "hang"});
  const std::vector<SocketOwner> peers = owners_.peers_of(::getpid());
  ASSERT_EQ(peers.size(), 1U);
  EXPECT_TRUE(peers.front().program.starts_with("left team"));
}

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// When both teams join at once, cls looked at all processes for each of their players, and stood
// still for seconds on a busy host.
TEST_F(SocketOwnersTest, LookAtProcessesOnceForAllPeers) {
  std::vector<base::UdpSocket> sockets;
  const auto seconds_for_new = [&](int count) {
    for (int i = 0; i < count; ++i) {
      auto peer = base::UdpSocket::bind(loopback(0));
      auto server = base::UdpSocket::bind(loopback(0));
      EXPECT_TRUE(server->connect(loopback(peer->local_port())));
      sockets.push_back(*std::move(peer));
      sockets.push_back(*std::move(server));
    }

    const double before = cpu_seconds();
    EXPECT_EQ(owners_.peers_of(::getpid()).size(), sockets.size() / 2);
    return cpu_seconds() - before;
  };
  const double one = seconds_for_new(1);
  EXPECT_LT(seconds_for_new(100), 20 * one);
}

TEST_F(SocketOwnersTest, NeedAGuardOfTheirParent) {
  EXPECT_FALSE(SocketOwners::of_programs_beside());
}

}  // namespace
}  // namespace cls::process
