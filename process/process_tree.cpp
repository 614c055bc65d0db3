// Reads /proc/PID/stat of every process and follows the parents.
#include "process/process_tree.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/system/unique_fd.h"

namespace cls::process {
namespace {

double ticks_to_seconds(unsigned long long ticks) {
  static const double per_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  return static_cast<double>(ticks) / per_second;
}

// /proc/PID/task/TID/schedstat is "RUN READY SLICES", in nanoseconds.
double delayed_seconds(pid_t pid) {
  double seconds = 0.0;
  std::error_code code;
  const std::filesystem::path tasks = "/proc/" + std::to_string(pid) + "/task";
  for (std::filesystem::directory_iterator task(tasks, code), end; !code && task != end;
       task.increment(code)) {
    std::ifstream file(task->path() / "schedstat");
    double run = 0.0;
    double ready = 0.0;
    if (file >> run >> ready) seconds += ready * 1e-9;
  }
  return seconds;
}

std::vector<ProcessEntry> all_processes() {
  std::vector<ProcessEntry> entries;
  for (const int pid : all_pids()) {
    if (const auto entry = read_process(pid)) entries.push_back(*entry);
  }
  return entries;
}

}  // namespace

// The line is "PID (NAME) STATE PPID ..." where NAME may contain anything, also ')' and spaces.
std::optional<ProcessEntry> read_process(pid_t pid) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/proc/%d/stat", pid);
  const base::UniqueFd file(::open(path.data(), O_RDONLY | O_CLOEXEC));
  if (!file) return std::nullopt;

  std::array<char, 1024> text{};
  const ssize_t size = ::read(file.get(), text.data(), text.size() - 1);
  if (size <= 0) return std::nullopt;

  const std::string_view line(text.data(), static_cast<std::size_t>(size));
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string_view::npos) return std::nullopt;

  char state = '?';
  int parent = 0;
  unsigned long long user = 0;
  unsigned long long system = 0;
  long long fetched_user = 0;
  long long fetched_system = 0;
  int threads = 0;
  const int fields =
      std::sscanf(text.data() + name_end + 1,
                  " %c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u %llu %llu %lld %lld %*d %*d %d",
                  &state, &parent, &user, &system, &fetched_user, &fetched_system, &threads);

  if (fields != 7 || state == 'X') return std::nullopt;
  // A process whose first thread has exited is a Z too, while its other threads run.
  if (state == 'Z' && threads < 2) return std::nullopt;

  return ProcessEntry{.pid = pid,
                      .parent = parent,
                      .threads = threads,
                      .cpu_seconds = ticks_to_seconds(user + system),
                      .reaped_cpu_seconds = ticks_to_seconds(
                          static_cast<unsigned long long>(fetched_user + fetched_system))};
}

std::vector<int> all_pids() {
  std::vector<int> pids;
  std::error_code code;
  for (std::filesystem::directory_iterator entry("/proc", code), end; !code && entry != end;
       entry.increment(code)) {
    const int pid = std::atoi(entry->path().filename().c_str());
    if (pid > 0) pids.push_back(pid);
  }
  std::ranges::sort(pids);
  return pids;
}

std::string short_name(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/comm");
  std::string name;
  std::getline(file, name);
  return name;
}

std::vector<ProcessEntry> descendants_of(pid_t root) {
  const std::vector<ProcessEntry> all = all_processes();
  std::vector<ProcessEntry> tree;

  const auto add_children = [&](pid_t parent) {
    for (const ProcessEntry& entry : all) {
      if (entry.parent == parent && entry.pid != parent) tree.push_back(entry);
    }
  };

  add_children(root);
  for (std::size_t i = 0; i < tree.size(); ++i) add_children(tree[i].pid);
  return tree;
}

double living_delayed_seconds(pid_t root) {
  double seconds = 0.0;
  for (const ProcessEntry& entry : descendants_of(root)) seconds += delayed_seconds(entry.pid);
  return seconds;
}

double living_cpu_seconds(pid_t root) {
  double seconds = 0.0;
  for (const ProcessEntry& entry : descendants_of(root)) {
    seconds += entry.cpu_seconds + entry.reaped_cpu_seconds;
  }
  return seconds;
}

}  // namespace cls::process
