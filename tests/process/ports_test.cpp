// Free ports, reserved ports, and owners of ports in use.
#include "process/ports.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/system/unique_fd.h"
#include "tests/process/test_guard.h"

namespace cls::process {
namespace {

/// All names under which programs of cls reserve ports. Empty without descriptors for them.
std::vector<base::UniqueFd> take_all_marks() {
  constexpr int kFirst = 20000;
  constexpr int kLast = 31999;
  std::vector<base::UniqueFd> marks;

  for (int port = kFirst; port <= kLast; ++port) {
    base::UniqueFd mark(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "cls-port-" + std::to_string(port);
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    if (!mark || ::bind(mark.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0)
      return {};
    marks.push_back(std::move(mark));
  }

  return marks;
}

TEST(Ports, ChoosesDistinctFreePorts) {
  const auto ports = ReservedPort::choose(30);
  ASSERT_TRUE(ports);

  std::set<int> numbers;
  for (const ReservedPort& port : *ports) {
    EXPECT_TRUE(port_is_free(Protocol::kTcp, port.number()));
    EXPECT_TRUE(port_is_free(Protocol::kUdp, port.number()));
    numbers.insert(port.number());
  }
  EXPECT_EQ(numbers.size(), 30U);
  EXPECT_LT(*numbers.rbegin(), 32768);
}

TEST(Ports, ChoosesConsecutivePorts) {
  const auto anywhere = ReservedPort::choose_row(3);
  ASSERT_TRUE(anywhere);
  ASSERT_EQ(anywhere->size(), 3U);
  const int first = anywhere->front().number();
  EXPECT_EQ((*anywhere)[1].number(), first + 1);
  EXPECT_EQ((*anywhere)[2].number(), first + 2);
}

TEST(Ports, ChoosesWishedPortsIfAllAreFree) {
  auto held = ReservedPort::choose_row(3);
  ASSERT_TRUE(held);

  const int first = held->front().number();
  const auto others = ReservedPort::choose_row(3, first);
  ASSERT_TRUE(others);
  EXPECT_NE(others->front().number(), first);
  held->clear();
  const auto wished = ReservedPort::choose_row(3, first);
  ASSERT_TRUE(wished);
  EXPECT_EQ(wished->front().number(), first);
}

// Of another user, they once stopped every match over UDP. The names belong to a network namespace,
// here of one thread, so that other tests keep theirs.
TEST(Ports, AreChosenAlsoWhenOthersHoldAllNames) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);

  rlimit many = before;
  many.rlim_cur = many.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &many);

  std::string skipped;
  std::thread([&skipped] {
    if (::unshare(CLONE_NEWNET) != 0) {
      skipped = "a network namespace is not permitted here";
      return;
    }
    const std::vector<base::UniqueFd> marks = take_all_marks();
    if (marks.empty()) {
      skipped = "12 000 descriptors are not permitted here";
      return;
    }
    const auto ports = ReservedPort::choose(3);
    EXPECT_TRUE(ports) << ports.error().message;
    const auto row = ReservedPort::choose_row(3);
    ASSERT_TRUE(row) << row.error().message;
    EXPECT_EQ((*row)[2].number(), row->front().number() + 2);
  }).join();

  ::setrlimit(RLIMIT_NOFILE, &before);
  if (!skipped.empty()) GTEST_SKIP() << skipped;
}

TEST(Ports, ReportsOwnerOfPortInUse) {
  MarkedHost processes;
  const auto ports = ReservedPort::choose(2);
  ASSERT_TRUE(ports);

  const int udp = (*ports)[0].number();
  const int tcp = (*ports)[1].number();
  EXPECT_TRUE(owners_of(Protocol::kUdp, udp).empty());
  EXPECT_FALSE(tcp_answers("127.0.0.1", tcp, 100));

  const auto child = processes.start_fake({"bind-udp", std::to_string(udp), "listen-tcp",
                                           std::to_string(tcp), "print", "bound", "hang"});
  ASSERT_TRUE(saw_line(*child, "bound"));
  EXPECT_FALSE(port_is_free(Protocol::kUdp, udp));
  EXPECT_TRUE(port_is_free(Protocol::kTcp, udp));
  EXPECT_FALSE(port_is_free(Protocol::kTcp, tcp));

  const int pid = child->status().pid;
  EXPECT_EQ(port_taken_text(Protocol::kUdp, udp), "UDP port " + std::to_string(udp) +
                                                      " is taken by cls_fake_proces (process " +
                                                      std::to_string(pid) + ")");
  EXPECT_EQ(port_taken_text(Protocol::kTcp, tcp).substr(0, 9), "TCP port ");
  EXPECT_EQ(ports_of(Protocol::kUdp, pid), std::vector<int>{udp});
  EXPECT_EQ(ports_of(Protocol::kTcp, pid), std::vector<int>{tcp});
  EXPECT_TRUE(tcp_answers("127.0.0.1", tcp, 1000));
  EXPECT_TRUE(tcp_answers("localhost", tcp, 1000));
  EXPECT_TRUE(tcp_answers(loopback_host(), tcp, 1000));
}

TEST(Ports, LimitsWaitForTcpConnection) {
  EXPECT_FALSE(tcp_answers("no.such.host.invalid", 1, 100));
  EXPECT_FALSE(tcp_answers("[::1]", 1, 100));
}

TEST(Ports, SaysWhyThereIsNone) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit few = before;
  few.rlim_cur = 3;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  const auto ports = ReservedPort::choose(1);
  ::setrlimit(RLIMIT_NOFILE, &before);

  ASSERT_FALSE(ports);
  EXPECT_EQ(ports.error().message,
            "no 1 free port between 20000 and 31999 after 2000 tries; the last one: Too many open "
            "files");
}

}  // namespace
}  // namespace cls::process
