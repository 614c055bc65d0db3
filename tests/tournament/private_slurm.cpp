// Configuration and daemons of the private Slurm.
#include "tests/tournament/private_slurm.h"

#include <fmt/format.h>
#include <pwd.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/index.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::chrono::seconds kReadyTimeout{120};

// The daemons are in folders that PATH may lack.
fs::path find_program(const std::string& name) {
  for (const char* folder : {"/usr/sbin", "/usr/bin", "/usr/local/sbin", "/usr/local/bin"}) {
    if (::access((fs::path(folder) / name).c_str(), X_OK) == 0) return fs::path(folder) / name;
  }
  return {};
}

std::string short_host_name() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  const std::string whole = name;
  return whole.substr(0, whole.find('.'));
}

std::string user_name() {
  const passwd* user = ::getpwuid(::geteuid());
  return user == nullptr ? "root" : user->pw_name;
}

// No cgroups, no accounting. A requeued task waits until its credential expires: at least 5 s.
constexpr const char* kConfiguration = R"(ClusterName=clstest
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldPort={port0}
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
MpiDefault=none
ReturnToService=2
KillWait=5
MinJobAge=30
SlurmdTimeout=5
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MaxArraySize={array}
NodeName=cls[0-1] NodeHostname={host} NodeAddr=127.0.0.1 Port=[{port1},{port2}] CPUs=2 RealMemory=1 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
)";

}  // namespace

std::string PrivateSlurm::missing() {
  std::string names;
  for (const char* name :
       {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo"}) {
    if (find_program(name).empty()) names += std::string(names.empty() ? "" : ", ") + name;
  }
  return names;
}

PrivateSlurm::PrivateSlurm(int max_array_size) : max_array_size_(max_array_size) {
  auto ports = process::ReservedPort::choose(3);
  if (!ports) throw std::runtime_error(ports.error().message);
  ports_ = *std::move(ports);
  write_files();
  const std::string munge = (folder_.path() / "munge").string();
  munged_ = start(
      "munged", {find_program("munged"), "--foreground", "--force", "--socket=" + munge + "/socket",
                 "--key-file=" + munge + "/key", "--pid-file=" + munge + "/pid",
                 "--log-file=" + munge + "/log", "--seed-file=" + munge + "/seed"});
  const std::atomic<int> never{0};
  const auto listens = [&] { return fs::exists(munge + "/socket"); };
  if (process::wait_until_ready(*munged_, listens, kReadyTimeout, never) !=
      process::Readiness::kReady) {
    throw std::runtime_error("munged does not start: " + logs());
  }

  controller_ = start("controller", {find_program("slurmctld"), "-D", "-f",
                                     (folder_.path() / "slurm.conf").string()});
  start_node(0);
  start_node(1);
}

bool PrivateSlurm::wait_until_ready() {
  const auto limit = std::chrono::steady_clock::now() + kReadyTimeout;
  while (run({"sinfo", "--noheader", "--Node", "--format=%T"}) != "idle\nidle\n") {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::sleep_for(100ms);
  }
  return true;
}

void PrivateSlurm::kill_daemon(int node) {
  ::kill(nodes_.at(base::index(node))->status().pid, SIGKILL);
}

void PrivateSlurm::cut_power(int node) {
  const auto& daemon = nodes_.at(base::index(node));
  daemon->end(0ms);
  daemon->wait_gone(20s);
}

void PrivateSlurm::start_node(int node) {
  const std::string name = fmt::format("cls{}", node);
  nodes_.at(base::index(node)) = start(name, {find_program("slurmd"), "-D", "-N", name, "-f",
                                              (folder_.path() / "slurm.conf").string()});
}

std::vector<std::string> PrivateSlurm::environment() const {
  return {"SLURM_CONF=" + (folder_.path() / "slurm.conf").string(),
          std::string(tests::kMarkVariable) + "=" + host_.mark};
}

std::string PrivateSlurm::run(std::vector<std::string> argv) const {
  argv.front() = find_program(argv.front()).string();
  return tests::run(std::move(argv), environment()).out;
}

std::string PrivateSlurm::logs() const {
  constexpr std::size_t kMaxLogBytes = 4000;
  std::string text;
  for (const char* name : {"munged", "controller", "cls0", "cls1"}) {
    const fs::path file = folder_.path() / (std::string(name) + ".log");
    if (!fs::exists(file)) continue;
    const std::string whole = tests::read_file(file);
    text += std::string(name) + ":\n" +
            whole.substr(whole.size() > kMaxLogBytes ? whole.size() - kMaxLogBytes : 0) + "\n";
  }
  return text;
}

std::shared_ptr<process::Child> PrivateSlurm::start(const std::string& name,
                                                    std::vector<std::string> argv) {
  process::CommandPlan plan;
  plan.name = name;
  plan.argv = std::move(argv);
  plan.folder = folder_.path();
  plan.log = folder_.path() / (name + ".log");
  plan.environment = {{"SLURM_CONF", (folder_.path() / "slurm.conf").string()}};
  return host_.start(std::move(plan));
}

void PrivateSlurm::write_files() {
  const fs::path munge = folder_.path() / "munge";
  fs::create_directories(munge);
  fs::create_directories(folder_.path() / "state");
  ::chmod(munge.c_str(), 0700);
  // Anyone who can read the folder can use this Slurm; it runs for about a minute.
  std::ofstream(munge / "key") << std::string(64, 'k') << host_.mark;
  ::chmod((munge / "key").c_str(), 0400);
  std::ofstream(folder_.path() / "slurm.conf")
      << fmt::format(kConfiguration, fmt::arg("host", short_host_name()),
                     fmt::arg("user", user_name()), fmt::arg("folder", folder_.path().string()),
                     fmt::arg("array", max_array_size_), fmt::arg("port0", ports_[0].number()),
                     fmt::arg("port1", ports_[1].number()), fmt::arg("port2", ports_[2].number()));
}

}  // namespace cls::tournament
