// Fork and loop of the guard; killing of orphans at its end.
#include "process/guard.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include "process/keeper.h"
#include "process/namespace_maker.h"
#include "process/packet.h"
#include "process/process_tree.h"
#include "process/scratch_folder.h"
#include "process/socket_owner.h"

namespace cls::process {
namespace {

using Clock = std::chrono::steady_clock;

// Keepers allow 1 s after SIGTERM; what is still running after this time is killed with its keeper.
constexpr auto kOrphanTimeout = std::chrono::milliseconds(1500);
constexpr auto kGuardExitTimeout = std::chrono::seconds(4);
constexpr int kReapInterval = 20;  // ms

// First bytes of a packet without descriptors; the name of a folder follows.
constexpr char kDeleteAtExit = '+';
constexpr char kForget = '-';

const Guard* the_guard = nullptr;
std::string the_error;

base::Error failed_start() {
  the_error = fmt::format("no guard process: {}", std::strerror(errno));
  return base::Error{the_error};
}

// The title shown by ps: overwrites the arguments of cls where the kernel reads them.
class ProcessTitle {
 public:
  ProcessTitle(int argc, char** argv) {
    if (argc < 1) return;
    begin_ = argv[0];
    const char* end = begin_;
    for (int i = 0; i < argc && argv[i] == end; ++i) end += std::strlen(argv[i]) + 1;
    size_ = static_cast<std::size_t>(end - begin_);
  }

  void set(const std::string& title, const std::string& short_name) const {
    ::prctl(PR_SET_NAME, short_name.c_str());
    if (size_ == 0) return;
    std::memset(begin_, 0, size_);
    std::memcpy(begin_, title.data(), std::min(title.size(), size_ - 1));
  }

 private:
  char* begin_ = nullptr;
  std::size_t size_ = 0;
};

class GuardLoop {
 public:
  GuardLoop(base::UniqueFd socket, ProcessTitle title) : socket_(std::move(socket)), title_(title) {
    sigset_t children;
    ::sigemptyset(&children);
    ::sigaddset(&children, SIGCHLD);
    child_signals_ = base::UniqueFd(::signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
  }

  [[noreturn]] void run() {
    while (socket_) {
      std::array<pollfd, 2> waits{{{child_signals_.get(), POLLIN, 0}, {socket_.get(), POLLIN, 0}}};
      // Without a descriptor for signals it polls for exited children.
      ::poll(waits.data(), waits.size(), child_signals_ ? -1 : kReapInterval);
      if (waits[0].revents != 0 || !child_signals_) reap_children();
      if (waits[1].revents != 0) serve();
    }

    sweep();
    for (const std::string& folder : folders_) remove_tree(folder);
    ::_exit(0);
  }

 private:
  void serve() {
    Packet packet = receive_packet(socket_.get());
    if (packet.bytes.empty()) {
      socket_.reset();
      return;
    }

    if (packet.fds.empty()) {
      const std::string folder = packet.bytes.substr(1);
      if (packet.bytes[0] == kDeleteAtExit) folders_.insert(folder);
      if (packet.bytes[0] == kForget) folders_.erase(folder);
    } else if (packet.fds.size() == 1) {
      make_namespaces(std::move(packet));
    } else {
      start(std::move(packet));
    }
  }

  // After a failed fork cls sees the connection closed without a reply.
  void make_namespaces(Packet packet) {
    const auto request = read_plain<NamespaceRequest>(packet);
    if (!request) return;
    const pid_t pid = ::fork();
    if (pid > 0) keepers_.insert(pid);
    if (pid != 0) return;
    become("match-network", "match-network");
    run_namespace_maker(std::move(packet.fds[0]), *request);
  }

  void start(Packet packet) {
    const auto plan = decode_plan(packet.bytes);
    if (!plan || packet.fds.size() < 2 + plan->passed.size()) return;
    KeeperFds fds = keeper_fds(std::move(packet.fds), plan->passed.size());
    if (fds.user) return start_in_namespaces(std::move(fds), *plan);

    const pid_t pid = ::fork();
    if (pid > 0) keepers_.insert(pid);
    if (pid != 0) return;
    become_keeper(*plan);
    run_keeper(std::move(fds), *plan);
  }

  // A process cannot become the first one of a namespace, but its child can: the guard inherits
  // that, and learns its number from the process that exits.
  void start_in_namespaces(KeeperFds fds, const CommandPlan& plan) {
    auto number = make_socket_pair();
    if (!number) return;
    const pid_t between = ::fork();
    if (between < 0) return;
    if (between > 0) {
      number->second.reset();
      const Packet packet = receive_packet(number->first.get());
      ::waitpid(between, nullptr, 0);
      if (!packet.bytes.empty()) keepers_.insert(std::atoi(packet.bytes.c_str()));
      return;
    }

    become_keeper(plan);
    enter_for_keeper(fds);
    const pid_t first = ::fork();
    if (first > 0) send_packet(number->second.get(), std::to_string(first));
    if (first != 0) ::_exit(0);
    number.reset();
    run_keeper(std::move(fds), plan);
  }

  void become(const std::string& title, const std::string& short_name) {
    socket_.reset();
    child_signals_.reset();
    title_.set(title, short_name);
  }
  void become_keeper(const CommandPlan& plan) {
    become("match-keeper of " + plan.name, std::string(kKeeperMark) + plan.name);
  }

  // False when no child is left.
  bool reap_children() {
    signalfd_siginfo ignored{};
    while (::read(child_signals_.get(), &ignored, sizeof ignored) > 0) {
    }

    while (true) {
      int status = 0;
      const pid_t pid = ::waitpid(-1, &status, WNOHANG);
      if (pid < 0) return errno != ECHILD;
      if (pid == 0) return true;
      // A keeper was killed: the guard has inherited its processes, which are orphans now.
      if (keepers_.erase(pid) > 0 && WIFSIGNALED(status)) kill_orphans();
    }
  }

  // The guard of an orphan ends its processes and deletes its folders, and then itself: only what
  // remains at the end of sweep() is killed.
  void kill_orphans() const {
    std::set<pid_t> kept = keepers_;
    for (const ProcessEntry& entry : descendants_of(::getpid())) {
      const bool cleans_up = short_name(entry.pid).starts_with(kGuardMark);
      if (cleans_up || kept.count(entry.parent) != 0) kept.insert(entry.pid);
      if (kept.count(entry.pid) == 0) ::kill(entry.pid, SIGKILL);
    }
  }

  void sweep() {
    const auto kill_at = Clock::now() + kOrphanTimeout;
    while (reap_children()) {
      if (Clock::now() >= kill_at) {
        for (const ProcessEntry& entry : descendants_of(::getpid())) ::kill(entry.pid, SIGKILL);
      }
      pollfd wait{child_signals_.get(), POLLIN, 0};
      ::poll(&wait, 1, 10);
    }
  }

  base::UniqueFd socket_;
  base::UniqueFd child_signals_;
  ProcessTitle title_;
  std::set<pid_t> keepers_;
  std::set<std::string> folders_;  ///< to delete at the end
};

// Closes all files, sockets and terminals inherited from the caller of cls, but for this one.
base::UniqueFd close_others(base::UniqueFd socket) {
  const int null = ::open("/dev/null", O_RDWR);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, fd);

  constexpr int kKeptFd = 3;
  if (socket.get() != kKeptFd) {
    ::dup2(socket.get(), kKeptFd);
    socket = base::UniqueFd(kKeptFd);
  }

  ::closefrom(kKeptFd + 1);
  ::fcntl(kKeptFd, F_SETFD, FD_CLOEXEC);
  return socket;
}

[[noreturn]] void run_guard(base::UniqueFd socket, ProcessTitle title) {
  ::setsid();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);

  // If it were ignored, the kernel would not report exited children.
  std::signal(SIGCHLD, SIG_DFL);

  sigset_t all;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);

  title.set(fmt::format("match-guard of process {}", ::getppid()), std::string(kGuardMark));
  GuardLoop(close_others(std::move(socket)), title).run();
}

}  // namespace

Guard::Guard(base::UniqueFd socket, pid_t pid) : socket_(std::move(socket)), pid_(pid) {
  the_guard = this;
}

Guard::Guard(Guard&& other) noexcept
    : socket_(std::move(other.socket_)), pid_(std::exchange(other.pid_, 0)) {
  if (the_guard == &other) the_guard = this;
}

Guard::~Guard() {
  if (pid_ == 0) return;
  if (the_guard == this) the_guard = nullptr;
  socket_.reset();

  // The guard may have been stopped with SIGSTOP; then it cannot exit on its own.
  const auto kill_at = Clock::now() + kGuardExitTimeout;
  while (::waitpid(pid_, nullptr, WNOHANG) == 0 || errno == EINTR) {
    if (Clock::now() >= kill_at) ::kill(pid_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void Guard::delete_at_exit(const std::filesystem::path& folder) const {
  send_packet(socket_.get(), kDeleteAtExit + folder.string());
}

void Guard::forget(const std::filesystem::path& folder) const {
  send_packet(socket_.get(), kForget + folder.string());
}

const Guard* Guard::active() { return the_guard; }

const std::string& Guard::start_error() { return the_error; }

base::Result<Guard> Guard::start(int argc, char** argv) {
  auto sockets = make_socket_pair();
  if (!sockets) return failed_start();

  const pid_t pid = ::fork();
  if (pid < 0) return failed_start();
  if (pid == 0) {
    sockets->first.reset();
    run_guard(std::move(sockets->second), ProcessTitle(argc, argv));
  }
  return Guard(std::move(sockets->first), pid);
}

}  // namespace cls::process
