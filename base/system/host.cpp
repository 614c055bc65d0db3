// Queries of the operating system.
#include "base/system/host.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/index.h"
#include "base/system/control_group.h"
#include "base/text/trimmed.h"

namespace cls::base {
namespace {

std::tm utc() {
  return fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
}

// The value behind `key` in a file of lines, without separator and quotes.
std::string value_in(const char* path, std::string_view key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) {
      return std::string(trimmed(std::string_view(line).substr(key.size()), " \t:=\""));
    }
  }
  return {};
}

}  // namespace

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", utc()); }

std::string utc_stamp() { return fmt::format("{:%Y%m%dT%H%M%SZ}", utc()); }

std::string host_name() {
  char buffer[256] = {};
  return gethostname(buffer, sizeof buffer - 1) == 0 ? buffer : "";
}

Machine this_machine() {
  Machine machine;
  machine.os = value_in("/etc/os-release", "PRETTY_NAME=");
  utsname names{};
  if (uname(&names) == 0) machine.kernel = fmt::format("{} {}", names.sysname, names.release);
  machine.cpu = value_in("/proc/cpuinfo", "model name");
  machine.cores = usable_cores();

  const long pages = sysconf(_SC_PHYS_PAGES);
  if (pages > 0) machine.memory_bytes = std::int64_t{pages} * sysconf(_SC_PAGESIZE);
  return machine;
}

double load_average() {
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : 0.0;
}

std::string busy_host() {
  const double load = load_average();
  const std::size_t processors = allowed_processors().size();
  if (load <= 2.0 * static_cast<double>(processors)) return {};
  return fmt::format("this host is busy: load {:.1f} on {} processors", load, processors);
}

std::vector<int> allowed_processors() {
  std::vector<int> processors;
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return processors;

  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(index(cpu), &allowed)) processors.push_back(cpu);
  }
  return processors;
}

std::vector<std::vector<int>> allowed_cores() {
  // The hardware threads of one core have the same list of siblings.
  std::map<std::string, std::vector<int>> cores;
  for (const int cpu : allowed_processors()) {
    std::ifstream file(
        fmt::format("/sys/devices/system/cpu/cpu{}/topology/thread_siblings_list", cpu));
    std::string siblings;
    if (!std::getline(file, siblings)) siblings = fmt::to_string(cpu);
    cores[siblings].push_back(cpu);
  }

  std::vector<std::vector<int>> sorted;
  for (auto& [siblings, processors] : cores) sorted.push_back(std::move(processors));
  std::ranges::sort(sorted);
  return sorted;
}

std::array<std::vector<int>, 2> split_in_half(const std::vector<std::vector<int>>& cores) {
  std::array<std::vector<int>, 2> halves;
  if (cores.size() == 1) {
    std::vector<std::vector<int>> threads;
    for (const int processor : cores.front()) threads.push_back({processor});
    if (threads.size() >= 2) halves = split_in_half(threads);
    return halves;
  }

  for (std::size_t i = 0; i < cores.size() / 2; ++i) {
    const std::vector<int>& right = cores[cores.size() - cores.size() / 2 + i];
    halves[0].insert(halves[0].end(), cores[i].begin(), cores[i].end());
    halves[1].insert(halves[1].end(), right.begin(), right.end());
  }
  return halves;
}

int usable_cores() {
  const int cores = std::max(1, static_cast<int>(allowed_cores().size()));
  return std::min(cores, processor_quota().value_or(cores));
}

}  // namespace cls::base
