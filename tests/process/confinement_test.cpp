// What confined programs may do to themselves and not to others, by the programs that do it.
#include "process/confinement.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "process/process_host.h"
#include "tests/process/test_guard.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

using namespace std::chrono_literals;

class Confinement : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_confine()) GTEST_SKIP() << "this kernel has no seccomp";
  }

  int exit_code_of(const std::string& command, bool confined = true) {
    CommandPlan plan = shell_command("the shell", command);
    plan.confined = confined;
    plan.log = folder_.path() / "log";
    const auto child = processes_.start(plan);
    EXPECT_TRUE(child->wait_gone(20s));
    const auto exit = child->status().exit;
    return !exit || exit->by_signal ? -1 : exit->number;
  }
  std::string output() const { return tests::read_file(folder_.path() / "log"); }

  tests::TemporaryFolder folder_;
  MarkedHost processes_;
};

/// Changes of process P. Each is possible for a program of the same user that is not confined.
const std::vector<std::string>& changes() {
  static const std::vector<std::string> all = {"prlimit --pid P --core=0:0", "renice -n 19 -p P",
                                               "taskset -cp 0 P", "ionice -c 3 -p P"};
  return all;
}

std::string with_process(std::string command, const std::string& process) {
  return command.replace(command.find(" P") + 1, 1, process);
}

TEST_F(Confinement, ForbidsChangesOfOtherProcesses) {
  for (const std::string& change : changes()) {
    const std::string other = "sleep 60 & other=$!; " + with_process(change, "$other") +
                              "; code=$?; kill $other; exit $code";
    EXPECT_EQ(exit_code_of(other, false), 0) << change << ": " << output();
    EXPECT_NE(exit_code_of(other), 0) << change;
    EXPECT_NE(output().find("not permitted"), std::string::npos) << output();
  }
}

TEST_F(Confinement, ForbidsThemAlsoForDescendantsAndByGroupOrUser) {
  EXPECT_NE(exit_code_of("sh -c 'setsid prlimit --pid $PPID --core=0:0'"), 0);
  EXPECT_NE(exit_code_of("renice -n 19 -g $$"), 0);
  EXPECT_NE(exit_code_of("renice -n 19 -u $(id -u)"), 0);
  EXPECT_NE(exit_code_of("ionice -c 3 -P $$"), 0);
}

TEST_F(Confinement, AllowsChangesOfItself) {
  for (const char* command :
       {"ulimit -t 100 && ulimit -S -n 64", "nice -n 1 true", "taskset -c 0 true", "chrt -b 0 true",
        "ionice -c 3 true", "prlimit --core=0 true", "prlimit --pid $PPID --core"}) {
    EXPECT_EQ(exit_code_of(command), 0) << command << ": " << output();
  }
}

TEST_F(Confinement, SchedulesOtherProcessesInVain) {
  const std::string change = "sleep 60 & chrt -b -p 0 $!; chrt -p $!; kill $!";
  EXPECT_EQ(exit_code_of(change, false), 0) << output();
  EXPECT_NE(output().find("SCHED_BATCH"), std::string::npos) << output();
  EXPECT_EQ(exit_code_of(change), 0) << output();
  EXPECT_NE(output().find("SCHED_OTHER"), std::string::npos) << output();
}

/// In a confined process: 0 if a thread with that policy is started and is scheduled as usual.
int start_thread(int wanted, int priority) {
  if (!confine()) return 2;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
  pthread_attr_setschedpolicy(&attributes, wanted);
  sched_param parameters{};
  parameters.sched_priority = priority;
  pthread_attr_setschedparam(&attributes, &parameters);

  int policy = -1;
  const auto look = [](void* out) -> void* {
    *static_cast<int*>(out) = ::sched_getscheduler(0);
    return nullptr;
  };
  pthread_t thread{};
  if (pthread_create(&thread, &attributes, look, &policy) != 0) return 3;
  pthread_join(thread, nullptr);
  return policy == SCHED_OTHER ? 0 : 4;
}

// Players of Oxsy 2023 end if they cannot start a thread with a policy of its own.
TEST_F(Confinement, LetsProgramsStartThreadsWithAPolicy) {
  for (const int policy : {SCHED_OTHER, SCHED_FIFO, SCHED_RR}) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(start_thread(policy, policy == SCHED_OTHER ? 0 : 1));
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0) << policy;
  }
}

TEST_F(Confinement, TakesPrioritiesThatAHostGivesToAll) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit given{5, 5};
    for (const auto resource : {RLIMIT_RTPRIO, RLIMIT_NICE}) {
      if (::setrlimit(resource, &given) != 0) ::_exit(1);  // only root can give them
    }
    rlimit real_time{1, 1};
    rlimit nice{1, 1};
    if (!confine() || ::getrlimit(RLIMIT_RTPRIO, &real_time) != 0) ::_exit(2);
    if (::getrlimit(RLIMIT_NICE, &nice) != 0) ::_exit(2);
    ::_exit(real_time.rlim_max == 0 && nice.rlim_max == 0 ? 0 : 3);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == 1) GTEST_SKIP() << "only root can raise the limits";
  EXPECT_EQ(code, 0);
}

TEST_F(Confinement, DropsCapabilitiesAlsoAsRoot) {
  EXPECT_EQ(exit_code_of("grep -E 'Cap(Inh|Prm|Eff|Amb)' /proc/self/status; grep -q "
                         "'CapPrm:.0000000000000000' /proc/self/status && grep -q "
                         "'CapEff:.0000000000000000' /proc/self/status && grep -q "
                         "'NoNewPrivs:.1' /proc/self/status"),
            0)
      << output();
}

// As root a program could read them by CAP_PERFMON.
TEST_F(Confinement, HidesTheMemoryOfProcessesWithPrivileges) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root has privileges to lose";
  const std::string pid = std::to_string(::getpid());
  for (const char* file : {"environ", "maps", "mem"}) {
    const std::string read = "head -c 1 /proc/" + pid + "/" + file + " > /dev/null";
    EXPECT_NE(exit_code_of(read), 0) << file;
  }
}

}  // namespace
}  // namespace cls::process
