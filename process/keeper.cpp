// Loop of a keeper: children, requests, escalation from SIGTERM to SIGKILL.
#include "process/keeper.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "process/launch.h"
#include "process/namespace_maker.h"
#include "process/packet.h"
#include "process/private_root.h"
#include "process/process_tree.h"

namespace cls::process {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kOrphanGraceSeconds = 1.0;
constexpr pid_t kFirstProcess = 1;  // of a process namespace
constexpr auto kKillInterval = std::chrono::milliseconds(10);

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

// CPU time of all descendants that have exited and were reaped, by the keeper or below it.
double reaped_cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

// True for a process that died of its limit of CPU time: by SIGXCPU, or, if it ignored that, by the
// SIGKILL that follows; also for a shell that reports such an end of its command.
bool died_of_cpu_limit(int status, const rusage& usage, int limit_s) {
  constexpr int kShellSignals = 128;
  if (limit_s == 0) return false;
  if (WIFEXITED(status)) return WEXITSTATUS(status) == kShellSignals + SIGXCPU;
  const double seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  return WTERMSIG(status) == SIGXCPU || (WTERMSIG(status) == SIGKILL && seconds >= limit_s);
}

[[noreturn]] void fail(const base::UniqueFd& control, LaunchStep step, int error) {
  send_report(control.get(), {.kind = KeeperReport::Kind::kFailed, .step = step, .number = error});
  ::_exit(0);
}

bool place_passed(const std::vector<base::UniqueFd>& passed) {
  for (std::size_t i = 0; i < passed.size(); ++i) {
    if (::dup3(passed[i].get(), kFirstPassedFd + static_cast<int>(i), O_CLOEXEC) < 0) return false;
  }
  return true;
}

// The numbers of processes in this namespace, which the kernel gives to as many (Linux 6.14). Where
// it does not, RLIMIT_NPROC and the match limit them.
void limit_processes(int limit) {
  constexpr int kLeast = 301;  // of the kernel
  if (limit == 0) return;
  const std::string text = std::to_string(std::max(limit, kLeast));
  const base::UniqueFd file(::open("/proc/sys/kernel/pid_max", O_WRONLY | O_CLOEXEC));
  if (file && ::write(file.get(), text.data(), text.size()) < 0) return;
}

class Keeper {
 public:
  Keeper(base::UniqueFd control, pid_t program, int cpu_limit_s)
      : control_(std::move(control)), program_(program), cpu_limit_s_(cpu_limit_s) {}

  [[noreturn]] void run(int child_signals) {
    report(KeeperReport::Kind::kStarted);
    while (true) {
      std::array<pollfd, 2> waits{{{child_signals, POLLIN, 0}, {control_.get(), POLLIN, 0}}};
      ::poll(waits.data(), control_ ? 2 : 1, timeout_ms());
      if (waits[0].revents != 0) {
        signalfd_siginfo ignored{};
        if (::read(child_signals, &ignored, sizeof ignored) < 0) continue;
      }

      reap_children();
      if (control_ && waits[1].revents != 0) obey();
      escalate();
    }
  }

 private:
  void report(KeeperReport::Kind kind) {
    KeeperReport report{.kind = kind, .at_cpu_limit = at_cpu_limit_, .pid = program_};
    if (exit_status_) {
      report.by_signal = WIFSIGNALED(*exit_status_);
      report.number = report.by_signal ? WTERMSIG(*exit_status_) : WEXITSTATUS(*exit_status_);
    }

    const pid_t self = ::getpid();
    if (kind == KeeperReport::Kind::kExited) {
      report.living = static_cast<std::int32_t>(descendants_of(self).size());
    }

    report.cpu_seconds = reaped_cpu_seconds();
    if (kind != KeeperReport::Kind::kGone) report.cpu_seconds += living_cpu_seconds(self);
    if (kind == KeeperReport::Kind::kUsage) {
      delayed_seconds_ = std::max(delayed_seconds_, living_delayed_seconds(self));
    }
    report.delayed_seconds = delayed_seconds_;
    if (!control_) return;
    // Only a descriptor tells cls which process that is outside of its namespace.
    base::UniqueFd program;
    if (kind == KeeperReport::Kind::kStarted && self == kFirstProcess) {
      program = base::UniqueFd(static_cast<int>(::syscall(SYS_pidfd_open, program_, 0)));
    }
    send_report(control_.get(), report, program.get());
  }

  void reap_children() {
    while (true) {
      int status = 0;
      rusage usage{};
      const pid_t pid = ::wait4(-1, &status, WNOHANG, &usage);
      const bool at_limit = pid > 0 && !kill_at_ && died_of_cpu_limit(status, usage, cpu_limit_s_);
      at_cpu_limit_ = at_cpu_limit_ || at_limit;

      if (pid == program_) {
        exit_status_ = status;
        report(KeeperReport::Kind::kExited);
      } else if (at_limit) {
        report(KeeperReport::Kind::kCpuLimit);
      } else if (pid < 0 && errno == ECHILD) {
        report(KeeperReport::Kind::kGone);
        ::_exit(0);
      } else if (pid <= 0) {
        return;
      }
    }
  }

  void obey() {
    const Packet packet = receive_packet(control_.get());
    if (packet.bytes.empty()) {
      control_.reset();
      end(kOrphanGraceSeconds, false);
      return;
    }

    const auto request = read_request(packet);
    if (!request) return;

    if (request->kind == KeeperRequest::Kind::kUsage) {
      report(KeeperReport::Kind::kUsage);
    } else {
      end(request->grace_s, request->kind == KeeperRequest::Kind::kEndGently);
    }
  }

  void end(double grace_s, bool gently) {
    if (!kill_at_) {
      delayed_seconds_ = std::max(delayed_seconds_, living_delayed_seconds(::getpid()));
    }
    const auto until = Clock::now() + std::chrono::microseconds(static_cast<long>(grace_s * 1e6));
    kill_at_ = kill_at_ ? std::min(*kill_at_, until) : until;
    if (gently && !exit_status_) {
      ask_to_end(program_);
    } else {
      ask_all_to_end();
    }
  }

  // Without /proc the descendants are unknown: those in the program's process group are left.
  template <typename Action>
  void for_each_descendant(Action action) const {
    const std::vector<ProcessEntry> entries = descendants_of(::getpid());
    for (const ProcessEntry& entry : entries) action(entry.pid);
    if (entries.empty()) action(-program_);
  }

  // A stopped process handles SIGTERM only after SIGCONT.
  static void ask_to_end(pid_t pid) {
    ::kill(pid, SIGTERM);
    ::kill(pid, SIGCONT);
  }

  void ask_all_to_end() {
    all_asked_ = true;
    for_each_descendant(ask_to_end);
  }

  int timeout_ms() const {
    if (!kill_at_) return -1;
    const auto left = *kill_at_ - Clock::now();
    if (left <= Clock::duration::zero()) return static_cast<int>(kKillInterval.count());
    return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count());
  }

  // Continues a termination that has begun.
  void escalate() {
    if (!kill_at_) return;
    if (Clock::now() >= *kill_at_) {
      // Repeated until nothing is left, because descendants may fork meanwhile.
      for_each_descendant([](pid_t pid) { ::kill(pid, SIGKILL); });
    } else if (exit_status_ && !all_asked_) {
      ask_all_to_end();
    }
  }

  base::UniqueFd control_;
  pid_t program_;
  int cpu_limit_s_;
  bool at_cpu_limit_ = false;
  double delayed_seconds_ = 0.0;
  std::optional<int> exit_status_;
  std::optional<Clock::time_point> kill_at_;
  bool all_asked_ = false;
};

}  // namespace

KeeperFds keeper_fds(std::vector<base::UniqueFd> all, std::size_t passed) {
  KeeperFds fds;
  fds.control = std::move(all[0]);
  fds.output = std::move(all[1]);
  const std::size_t end = 2 + passed;
  for (std::size_t i = 2; i < end; ++i) fds.passed.push_back(std::move(all[i]));
  if (all.size() > end) fds.user = std::move(all[end]);
  if (all.size() > end + 1) fds.network = std::move(all[end + 1]);
  return fds;
}

void enter_for_keeper(const KeeperFds& fds) {
  if (enter_namespaces(fds.user.get(), fds.network.get())) return;
  fail(fds.control, LaunchStep::kNamespaces, errno);
}

void run_keeper(KeeperFds fds, const CommandPlan& plan) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);

  // Only SIGKILL stops a keeper: it must outlive the program.
  sigset_t all;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);

  sigset_t children;
  ::sigemptyset(&children);
  ::sigaddset(&children, SIGCHLD);
  const base::UniqueFd child_signals(::signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
  if (!child_signals || !place_passed(fds.passed)) {
    fail(fds.control, LaunchStep::kProgram, errno);
  }
  if (fds.user && (!plan.files || !enter_private_root(*plan.files))) {
    fail(fds.control, LaunchStep::kMounts, errno);
  }
  if (fds.user) limit_processes(plan.limits.processes);

  fds.passed.clear();
  const Launch launched = launch(plan, fds.output.get());
  fds.output.reset();
  if (launched.pid == 0) fail(fds.control, launched.step, launched.error);

  Keeper(std::move(fds.control), launched.pid, plan.limits.cpu_seconds).run(child_signals.get());
}

}  // namespace cls::process
