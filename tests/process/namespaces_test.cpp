// What programs in namespaces of their own can reach: their files, and their network.
#include "process/namespaces.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "base/system/tcp_connect.h"
#include "base/system/udp_socket.h"
#include "process/packet.h"
#include "process/ports.h"
#include "process/process_tree.h"
#include "tests/process/test_guard.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class InNamespaces : public testing::Test {
 protected:
  void SetUp() override {
    if (!missing_namespaces().empty()) GTEST_SKIP() << missing_namespaces();
    for (const char* name : {"own", "others", "shown"}) {
      fs::create_directory(path(name));
      std::ofstream(path(name) / "file") << name << '\n';
    }
    namespaces_ = created();
  }

  static std::shared_ptr<const Namespaces> created() {
    auto made = Namespaces::create();
    if (!made) throw std::runtime_error(made.error().message);
    return *std::move(made);
  }

  fs::path path(const std::string& name) const { return fs::canonical(folder_.path()) / name; }

  CommandPlan plan_of(const std::string& command) const {
    CommandPlan plan = shell_command("the shell", command);
    plan.folder = path("own");
    plan.log = folder_.path() / "log";
    plan.confined = true;
    plan.namespaces = namespaces_;
    plan.files = {{"/usr", "/etc", "/proc", "/sys", path("shown")},
                  {path("own"), "/dev/null", "/dev/urandom", "/none"},
                  {"/tmp", "/dev/shm"},
                  {{"/bin", "/usr/bin"}, {"/lib", "/usr/lib"}, {"/lib64", "/usr/lib64"}}};
    return plan;
  }

  int exit_code_of(const std::string& command) {
    const auto child = processes_.start(plan_of(command));
    EXPECT_TRUE(child->wait_gone(20s));
    const auto exit = child->status().exit;
    return !exit || exit->by_signal ? -1 : exit->number;
  }
  std::string output() const { return tests::read_file(folder_.path() / "log"); }

  tests::TemporaryFolder folder_;
  MarkedHost processes_;
  std::shared_ptr<const Namespaces> namespaces_;
};

TEST_F(InNamespaces, HaveTheirFolderAndWhatTheyMayRead) {
  EXPECT_EQ(exit_code_of("cat file && echo more >> file && cat " + path("shown/file").string() +
                         " && echo x > /dev/null && head -c 1 /dev/urandom > random && "
                         "cat < /dev/stdin && id -u"),
            0)
      << output();
  EXPECT_EQ(tests::read_file(path("own/file")), "own\nmore\n");
}

// PATH may name folders by links, and links in folders that are links.
TEST_F(InNamespaces, KnowFoldersByTheirLinks) {
  CommandPlan plan = plan_of("/by/link/cat file && echo out > /dev/stdout");
  plan.files->links.push_back({"/by/link", "/usr/bin"});
  plan.files->links.push_back({"/bin/deep/link", "/usr/bin"});
  const auto child = processes_.start(plan);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(child->status().exit->number, 0) << output();
}

TEST_F(InNamespaces, SeeNoOtherFiles) {
  const std::string other = path("others").string();
  EXPECT_NE(exit_code_of("ls " + other), 0);
  EXPECT_NE(exit_code_of("ls /home || ls /root || ls /var || ls /old || ls /new"), 0) << output();
}

TEST_F(InNamespaces, SeeNothingOfCoveredFolders) {
  fs::create_directories(path("own/covered"));
  std::ofstream(path("own/covered/file")) << "secret\n";
  CommandPlan plan = plan_of("ls -A covered; echo x > covered/file || echo closed");
  plan.files->covered = {path("own/covered"), path("own/missing")};
  EXPECT_EQ(decode_plan(encode(plan))->files, plan.files);
  const auto child = processes_.start(plan);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_NE(output().find("closed\n"), std::string::npos) << output();
  EXPECT_EQ(output().find("secret"), std::string::npos) << output();
  EXPECT_EQ(tests::read_file(path("own/covered/file")), "secret\n");
}

// By the same user, who owns all of them.
TEST_F(InNamespaces, ChangeNoPermissionsTimesOrAttributesOfOthers) {
  for (const char* change : {"chmod 0", "touch -d 2001-01-01", "chmod +x", "chown $(id -u)"}) {
    EXPECT_NE(exit_code_of(change + (" " + path("others/file").string())), 0) << change;
    EXPECT_NE(exit_code_of(change + (" " + path("shown/file").string())), 0) << change;
    EXPECT_EQ(exit_code_of(change + (" " + path("own/file").string())), 0) << change << output();
  }
  EXPECT_NE(exit_code_of("touch " + path("shown/new").string() + " /new /usr/new"), 0);
}

TEST_F(InNamespaces, HaveTemporaryFoldersOfTheirOwn) {
  const fs::path shared = "/dev/shm/" + path("x").parent_path().filename().string();
  std::ofstream(shared) << "mine\n";
  EXPECT_NE(exit_code_of("cat " + shared.string()), 0);
  EXPECT_EQ(exit_code_of("echo theirs > " + shared.string() + " && echo x > /tmp/x && cat /tmp/x"),
            0)
      << output();
  EXPECT_EQ(output(), "x\n");
  EXPECT_EQ(tests::read_file(shared), "mine\n");
  fs::remove(shared);
}

TEST_F(InNamespaces, SeeNoSharedMemoryOrQueuesOfOthers) {
  const int memory = ::shmget(IPC_PRIVATE, 64, IPC_CREAT | 0666);
  ASSERT_GE(memory, 0);
  EXPECT_EQ(exit_code_of("ipcs -m | grep -c 0x"), 1) << output();
  EXPECT_NE(exit_code_of("ipcrm -m " + std::to_string(memory)), 0);
  shmid_ds description{};
  EXPECT_EQ(::shmctl(memory, IPC_STAT, &description), 0);
  ::shmctl(memory, IPC_RMID, nullptr);
}

TEST_F(InNamespaces, SeeTheirOwnProcessesOnly) {
  EXPECT_EQ(exit_code_of("set -- /proc/[0-9]*; echo $#; cat /proc/1/comm; echo $$"), 0);
  EXPECT_EQ(output(), "2\nof the shell\n2\n");
  EXPECT_NE(exit_code_of("kill -KILL " + std::to_string(::getpid())), 0);
  EXPECT_EQ(exit_code_of("kill -KILL 1; kill -STOP 1; kill -0 $$"), 0) << "the keeper goes on";
}

TEST_F(InNamespaces, HaveNoPrivileges) {
  EXPECT_EQ(exit_code_of("grep -q 'CapEff:.0000000000000000' /proc/self/status"), 0);
  EXPECT_NE(exit_code_of("mount -t tmpfs none /tmp || umount " + path("own").string()), 0);
  EXPECT_NE(exit_code_of("ip link set lo down || ip addr add 127.0.0.9/8 dev lo"), 0);
}

TEST_F(InNamespaces, AreKnownByTheirNumberOnThisHost) {
  const auto child = processes_.start(plan_of("exec sleep 60"));
  const auto process = read_process(child->status().pid);
  ASSERT_TRUE(process);
  EXPECT_EQ(short_name(process->parent), "of the shell");
  child->end(1s);
  EXPECT_TRUE(child->wait_gone(5s));
}

// The kernel counts the processes of each namespace, or those of a user in it.
TEST_F(InNamespaces, HaveNoMoreProcessesThanTheyMay) {
  CommandPlan plan = plan_of(
      "i=0; while [ $i -lt 600 ] && sleep 60 & do i=$((i + 1)); echo $i > count; done; wait");
  plan.limits.processes = 310;
  const auto child = processes_.start(plan);
  const fs::path count = path("own/count");
  const auto counted = [&count] {
    int number = 0;
    std::ifstream(count) >> number;
    return number;
  };

  int last = -1;
  while (counted() != last || last < 1) {
    last = counted();
    std::this_thread::sleep_for(500ms);
  }
  EXPECT_LT(last, 311);
  EXPECT_GT(last, 200);
}

// The opposite of a process that leaves its parent, and its session.
TEST_F(InNamespaces, EndTogether) {
  const auto child = processes_.start(
      plan_of("trap '' TERM; setsid sh -c 'trap \"\" TERM; while :; do sleep 1; done' & echo on; "
              "wait"));
  ASSERT_TRUE(saw_line(*child, "on"));
  child->end(100ms);
  EXPECT_TRUE(child->wait_gone(5s));
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(InNamespaces, EndWithTheirKeeper) {
  const auto child = processes_.start(plan_of("setsid sleep 600 & echo on; wait"));
  ASSERT_TRUE(saw_line(*child, "on"));
  const auto process = read_process(child->status().pid);
  ASSERT_TRUE(process);
  ::kill(process->parent, SIGKILL);
  EXPECT_TRUE(child->wait_gone(5s));
  EXPECT_TRUE(processes_.nothing_left(2s));
}

TEST_F(InNamespaces, CountTheirTime) {
  const auto child =
      processes_.start(plan_of("sh -c 'ulimit -t 2; while :; do :; done'; echo on; sleep 9"));
  ASSERT_TRUE(saw_line(*child, "on"));
  // The kernel ends the loop by its count of ticks, a tenth earlier on a busy machine.
  EXPECT_GT(child->cpu_seconds(), 1.5);
}

constexpr const char* kReceive =
    "python3 -c \"import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); "
    "s.settimeout(5); s.sendto(b'hello', ('127.0.0.1', 7000)); print(s.recv(9).decode())\"";

TEST_F(InNamespaces, ReachOnlySocketsOpenedInTheirNetwork) {
  const auto address = *base::parse_ip_address("127.0.0.1", 7000);
  auto socket = namespaces_->door().bind_udp(address);
  ASSERT_TRUE(socket) << socket.error().message;
  EXPECT_EQ(socket->local_port(), 7000);
  EXPECT_FALSE(namespaces_->door().bind_udp(address)) << "the port is taken";

  const auto child = processes_.start(plan_of(kReceive));
  std::array<char, 16> buffer{};
  std::size_t size = 0;
  base::SocketAddress sender;
  const auto until = std::chrono::steady_clock::now() + 10s;
  while (socket->receive(buffer, size, sender) != 0 && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(5ms);
  }
  ASSERT_EQ(std::string(buffer.data(), size), "hello") << output();
  socket->send("answer", false, &sender);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(output(), "answer\n");
}

TEST_F(InNamespaces, AreReachedOverSocketsMadeInTheirNetwork) {
  const auto child = processes_.start(
      plan_of("exec python3 -c \"import socket; s = socket.create_server(('127.0.0.1', 7000)); "
              "print('on', flush=True); c, a = s.accept(); c.sendall(b'yes'); c.recv(1)\""));
  ASSERT_TRUE(saw_line(*child, "on")) << output();
  const auto until = std::chrono::steady_clock::now() + 10s;
  EXPECT_FALSE(base::connect_tcp("127.0.0.1", 7000, until)) << "in the network of this host";

  const auto make = [this](int family) {
    auto made = namespaces_->door().make_tcp(family);
    return made ? *std::move(made) : base::UniqueFd();
  };
  const base::UniqueFd socket = base::connect_tcp("127.0.0.1", 7000, until, make);
  ASSERT_TRUE(socket);
  std::array<char, 8> bytes{};
  ASSERT_TRUE(base::wait_for_events(socket.get(), POLLIN, until));
  EXPECT_EQ(::recv(socket.get(), bytes.data(), bytes.size(), 0), 3);
  EXPECT_EQ(ports_of(Protocol::kTcp, child->status().pid), std::vector<int>{7000});
  EXPECT_FALSE(namespaces_->door().make_tcp(AF_MAX));
}

TEST_F(InNamespaces, ReachNoSocketOfThisHostOrOfOthers) {
  const auto socket = base::UdpSocket::bind(*base::parse_ip_address("127.0.0.1", 0));
  ASSERT_TRUE(socket);
  const std::string port = std::to_string(socket->local_port());
  const std::string send =
      "python3 -c \"import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); "
      "s.connect(('127.0.0.1', " +
      port + ")); s.send(b'x'); s.send(b'x')\"";
  EXPECT_NE(exit_code_of(send), 0);
  EXPECT_NE(output().find("refused"), std::string::npos) << output();

  const auto others = created();
  EXPECT_TRUE(others->door().bind_udp(*base::parse_ip_address("127.0.0.1", 7001)));
  EXPECT_TRUE(namespaces_->door().bind_udp(*base::parse_ip_address("127.0.0.1", 7001)));

  CommandPlan outside = plan_of(send);
  outside.namespaces = nullptr;
  const auto child = processes_.start(outside);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(output(), "") << "the sandbox alone";
}

TEST_F(InNamespaces, ShareTheNetworkOnly) {
  const auto first = processes_.start(
      plan_of("echo x > /tmp/x; exec python3 -c \"import socket; s = socket.socket(socket.AF_INET, "
              "socket.SOCK_DGRAM); s.bind(('127.0.0.1', 7000)); print('on', flush=True); m, a = "
              "s.recvfrom(9); s.sendto(b'yes', a)\""));
  ASSERT_TRUE(saw_line(*first, "on"));
  CommandPlan second = plan_of(std::string("ls /tmp/x; ") + kReceive);
  second.log = folder_.path() / "second";
  const auto child = processes_.start(second);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(tests::read_file(folder_.path() / "second"),
            "ls: cannot access '/tmp/x': No such file or directory\nyes\n");
}

TEST_F(InNamespaces, PassSocketsToPrograms) {
  auto socket = namespaces_->door().bind_udp(*base::parse_ip_address("127.0.0.1", 7000));
  ASSERT_TRUE(socket);
  CommandPlan plan = plan_of("ls -l /proc/self/fd/100 | grep -c socket");
  plan.passed = {socket->fd()};
  const auto child = processes_.start(plan);
  EXPECT_TRUE(child->wait_gone(10s));
  EXPECT_EQ(output(), "1\n");

  plan.namespaces = nullptr;
  const auto outside = processes_.start(plan);
  EXPECT_TRUE(outside->wait_gone(10s));
  EXPECT_EQ(output(), "1\n") << "the sandbox alone";
}

TEST_F(InNamespaces, ReportAStartThatFails) {
  CommandPlan plan = plan_of("true");
  plan.files->writable.push_back("/proc/1/x");
  plan.argv.front() = "/bin/ls";
  plan.folder = path("others");
  const auto child = processes_.host.start(plan);
  ASSERT_FALSE(child);
  EXPECT_EQ(child.error().message,
            "cannot start the shell: " + path("others").string() + ": No such file or directory");
}

}  // namespace
}  // namespace cls::process
