// Boost.Process, plus process group, signals, affinity, limits, files and descriptors.
#include "process/launch.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/process/child.hpp>
#include <boost/process/error.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/posix.hpp>
#include <cerrno>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/system/unique_fd.h"
#include "process/confinement.h"
#include "process/connection_trap.h"
#include "process/landlock.h"
#include "process/pipe.h"

namespace cls::process {
namespace {

namespace bp = boost::process;

// Ignored and blocked signals survive exec; the caller of cls may have set some.
void reset_signals() {
  struct sigaction standard = {};
  standard.sa_handler = SIG_DFL;
  for (int signal = 1; signal < NSIG; ++signal) ::sigaction(signal, &standard, nullptr);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void set_affinity(const std::vector<int>& cpus) {
  if (cpus.empty()) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int cpu : cpus) CPU_SET(static_cast<std::size_t>(cpu), &set);
  ::sched_setaffinity(0, sizeof set, &set);  // on error (no such core) any core will do
}

// Never above the hard limit that cls itself has: only root may raise that.
void set_limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard) {
  rlimit limit{};
  ::getrlimit(resource, &limit);
  limit.rlim_max = std::min(limit.rlim_max, hard);
  limit.rlim_cur = std::min(limit.rlim_max, soft);
  ::setrlimit(resource, &limit);
}

void set_limits(const ResourceLimits& limits) {
  // Between them the process may handle SIGXCPU.
  constexpr rlim_t kSecondsUntilKill = 2;
  if (limits.memory != 0) set_limit(RLIMIT_DATA, limits.memory, limits.memory);
  if (limits.processes != 0) {
    const auto processes = static_cast<rlim_t>(limits.processes);
    set_limit(RLIMIT_NPROC, processes, processes);
  }
  if (limits.cpu_seconds == 0) return;
  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  set_limit(RLIMIT_CPU, seconds, seconds + kSecondsUntilKill);
}

// When a host runs out of memory, the kernel ends programs of a side before all others.
void be_ended_first() {
  constexpr std::string_view kPoints = "500";
  const base::UniqueFd file(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
  if (file && ::write(file.get(), kPoints.data(), kPoints.size()) < 0) return;
}

// Runs in the new process just before exec. Returns the step that failed, with errno set.
std::optional<LaunchStep> prepare(const CommandPlan& plan, int ruleset, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // the parent exited before prctl took effect
  if (!plan.folder.empty() && ::chdir(plan.folder.c_str()) != 0) return LaunchStep::kFolder;

  set_affinity(plan.cpus);
  set_limits(plan.limits);
  if (plan.confined) be_ended_first();

  // The descriptor with which Boost reports a failed exec must stay open until exec.
  ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  for (std::size_t i = 0; i < plan.passed.size(); ++i) {
    ::fcntl(kFirstPassedFd + static_cast<int>(i), F_SETFD, 0);
  }
  reset_signals();
  report_connections(plan);
  if (plan.files && !enforce_ruleset(ruleset)) return LaunchStep::kFiles;
  if (plan.confined && !confine()) return LaunchStep::kConfinement;
  return std::nullopt;
}

// Entries NAME=VALUE. Boost's environment reads behind the end of entries that are shorter than the
// name it looks for.
std::vector<std::string> environment_of(const CommandPlan& plan) {
  std::vector<std::string> entries;
  for (char** entry = plan.empty_environment ? nullptr : environ; entry && *entry; ++entry) {
    entries.emplace_back(*entry);
  }

  for (const EnvironmentChange& change : plan.environment) {
    const std::string start = change.name + "=";
    std::erase_if(entries, [&](const std::string& entry) { return entry.starts_with(start); });
    if (change.value) entries.push_back(start + *change.value);
  }
  return entries;
}

// The arguments of exec; `texts` must outlive them.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

Launch launch_program(const CommandPlan& plan, std::vector<std::string> argv, int output) {
  constexpr int kStepError = 100'000;  // more than any errno: the step is a multiple of it
  const base::UniqueFd ruleset = plan.files ? make_ruleset(*plan.files) : base::UniqueFd();
  if (plan.files && !ruleset) return {0, errno, LaunchStep::kFiles};

  // Boost's own arguments would take the first character of empty ones.
  std::vector<char*> arguments = pointers_to(argv);
  std::vector<std::string> entries = environment_of(plan);
  std::vector<char*> environment = pointers_to(entries);
  const pid_t parent = ::getpid();

  // Boost's own report is three writes, of which it may read the first alone.
  auto failure = make_pipe();
  if (!failure) return {0, errno, LaunchStep::kProgram};

  const auto before_exec = [&, parent](auto& executor) {
    executor.cmd_line = arguments.data();
    executor.env = environment.data();
    const auto failed = prepare(plan, ruleset.get(), parent);
    if (!failed) return;
    const int error = static_cast<int>(*failed) * kStepError + errno;
    if (::write(failure->write.get(), &error, sizeof error) < 0) ::_exit(126);
    ::_exit(127);
  };

  std::error_code error;
  bp::child child(bp::exe = argv.front(), bp::posix::fd.bind(1, output),
                  bp::posix::fd.bind(2, output), bp::extend::on_exec_setup = before_exec, error);

  failure->write.reset();

  if (!error && child.id() <= 0) error.assign(EMFILE, std::system_category());  // no pipe
  int failed = 0;
  if (!error && ::read(failure->read.get(), &failed, sizeof failed) == sizeof failed) {
    ::waitpid(child.id(), nullptr, 0);
    child.detach();
    error.assign(failed, std::system_category());
  }
  if (error) {
    return {0, error.value() % kStepError, static_cast<LaunchStep>(error.value() / kStepError)};
  }

  const pid_t pid = child.id();
  child.detach();  // the keeper reaps all its children itself
  return {.pid = pid};
}

}  // namespace

Launch launch(const CommandPlan& plan, int output) {
  Launch result = launch_program(plan, plan.argv, output);
  if (result.pid == 0 && result.error == ENOEXEC && result.step == LaunchStep::kProgram) {
    std::vector<std::string> argv = plan.argv;
    argv.insert(argv.begin(), "/bin/sh");
    result = launch_program(plan, std::move(argv), output);
  }
  return result;
}

}  // namespace cls::process
