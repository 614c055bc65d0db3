// The scripts of the fake Slurm; their files lie beside them.
#include "tests/tournament/fake_slurm.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace cls::tournament {
namespace {

constexpr const char* kBegin =
    "#!/bin/sh\n"
    "here=${0%/*}\n"
    "echo \"${0##*/} $*\" >>\"$here/calls\"\n"
    "if [ -e \"$here/down\" ]; then\n"
    "  echo 'error: Unable to contact slurm controller (connect failure)' >&2; exit 1\n"
    "fi\n";

constexpr const char* kSbatch = R"sh(
if [ -s "$here/refusals" ]; then
  sed -n 1p "$here/refusals" >&2
  sed -i 1d "$here/refusals"
  exit 1
fi
for argument; do
  case $argument in
    --array=*) array=${argument#--array=0-} ;;
    --job-name=*) name=${argument#--job-name=} ;;
  esac
done
last=${array%%[%]*}
if [ "$last" -ge "$(cat "$here/max_array_size")" ]; then
  echo 'sbatch: error: Batch job submission failed: Invalid job array specification' >&2
  exit 1
fi
alive=$(grep -c -e PENDING -e RUNNING "$here/queue")
if [ $((last + 1 + alive)) -gt "$(cat "$here/max_tasks")" ]; then
  echo 'sbatch: error: AssocMaxSubmitJobLimit' >&2
  echo 'sbatch: error: Batch job submission failed: Job violates accounting/QOS policy (job' \
    "submit limit, user's size and/or time limits)" >&2
  exit 1
fi
task=0
while [ $task -le "$last" ]; do
  echo "$name|$task|PENDING|Resources"
  task=$((task + 1))
done >>"$here/queue"
echo 4711
)sh";

constexpr const char* kSqueue = "cat \"$here/queue\"\n";

constexpr const char* kScancel = R"sh(
states='PENDING\|RUNNING'
for argument; do
  case $argument in
    --name=*) name=${argument#--name=} ;;
    --state=PENDING) states=PENDING ;;
  esac
done
sed -i "s/^\($name|[0-9]*\)|\($states\)|.*/\1|CANCELLED|None/" "$here/queue"
)sh";

constexpr const char* kScontrol =
    "echo 'MaxArraySize            = '\"$(cat \"$here/max_array_size\")\"\n";

constexpr const char* kSacct = "echo 'Slurm accounting storage is disabled' >&2\nexit 1\n";

}  // namespace

FakeSlurm::FakeSlurm() {
  write_program("sbatch", kSbatch);
  write_program("squeue", kSqueue);
  write_program("scancel", kScancel);
  write_program("scontrol", kScontrol);
  write_program("sacct", kSacct);
  write("queue", "");
  write("calls", "");
  set_max_array_size(1001);
  set_max_tasks(10000);
  const char* path = std::getenv("PATH");
  path_before_ = path == nullptr ? "" : path;
  setenv("PATH", (folder_.path().string() + ":" + path_before_).c_str(), 1);
}

FakeSlurm::~FakeSlurm() { setenv("PATH", path_before_.c_str(), 1); }

void FakeSlurm::set_max_array_size(int size) { write("max_array_size", std::to_string(size)); }

void FakeSlurm::set_max_tasks(int count) { write("max_tasks", std::to_string(count)); }

void FakeSlurm::refuse(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) text += message + "\n";
  write("refusals", text);
}

void FakeSlurm::set_down(bool down) {
  if (down) {
    write("down", "");
  } else {
    std::filesystem::remove(folder_.path() / "down");
  }
}

void FakeSlurm::set_state(const std::string& job, int task, const std::string& state,
                          const std::string& reason) {
  const std::string start = job + "|" + std::to_string(task) + "|";
  std::string text;
  for (std::string line : queue()) {
    if (line.starts_with(start)) line = state.empty() ? "" : start + state + "|" + reason;
    if (!line.empty()) text += line + "\n";
  }
  write("queue", text);
}

std::vector<std::string> FakeSlurm::queue() const { return lines("queue"); }

int FakeSlurm::count(const std::string& state) const {
  const auto all = queue();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const std::string& line) {
    return line.find("|" + state + "|") != std::string::npos;
  }));
}

std::vector<std::string> FakeSlurm::calls(const std::string& program) const {
  auto all = lines("calls");
  std::erase_if(all, [&](const std::string& line) { return !line.starts_with(program + " "); });
  return all;
}

void FakeSlurm::write_program(const std::string& name, const std::string& text) {
  write(name, kBegin + text);
  ::chmod((folder_.path() / name).c_str(), 0755);
}

void FakeSlurm::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_.path() / name) << text;
}

std::vector<std::string> FakeSlurm::lines(const std::string& name) const {
  std::vector<std::string> all;
  std::ifstream stream(folder_.path() / name);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

}  // namespace cls::tournament
