// Reads statm, smaps_rollup, the roots and the descriptors of processes in /proc.
#include "process/program_use.h"

#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "process/guard.h"
#include "process/process_tree.h"
#include "process/socket_owner.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFoldersInMemory[] = {"/tmp", "/dev/shm"};

fs::path folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

struct ProgramTree {
  std::vector<pid_t> keepers;
  std::vector<ProcessEntry> processes;
};

ProgramTree tree_of_programs(std::string_view prefix) {
  ProgramTree tree;
  const Guard* guard = Guard::active();
  if (guard == nullptr) return tree;

  const std::string mark = std::string(kKeeperMark).append(prefix);
  std::set<pid_t> found;
  for (const ProcessEntry& entry : descendants_of(guard->pid())) {
    if (entry.parent == guard->pid() && short_name(entry.pid).starts_with(mark)) {
      tree.keepers.push_back(entry.pid);
      found.insert(entry.pid);
    } else if (found.contains(entry.parent)) {
      tree.processes.push_back(entry);
      found.insert(entry.pid);
    }
  }
  return tree;
}

// Pages of memory that no file and no other process stands for, but those shared after a fork.
std::uint64_t private_memory(pid_t pid) {
  static const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  std::ifstream file(folder_of(pid) / "statm");
  std::uint64_t size = 0;
  std::uint64_t resident = 0;
  std::uint64_t shared = 0;
  if (!(file >> size >> resident >> shared)) return 0;
  return (resident - std::min(resident, shared)) * page;
}

// The same with its part of the pages that processes share; takes milliseconds for a large one.
std::uint64_t part_of_memory(pid_t pid) {
  std::ifstream file(folder_of(pid) / "smaps_rollup");
  for (std::string word; file >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "Pss_Anon:" && file >> kilobytes) return kilobytes << 10;
  }
  return private_memory(pid);
}

// Zero for a keeper that sees the folders of this host.
std::uint64_t bytes_in_own_folders(pid_t keeper) {
  std::uint64_t bytes = 0;
  for (const char* folder : kFoldersInMemory) {
    const std::string own = folder_of(keeper).string() + "/root" + folder;
    struct stat inside = {};
    struct stat outside = {};
    struct statvfs space = {};
    if (::stat(own.c_str(), &inside) != 0 || ::stat(folder, &outside) != 0) continue;
    if (inside.st_dev == outside.st_dev || ::statvfs(own.c_str(), &space) != 0) continue;
    bytes += std::uint64_t{space.f_blocks - space.f_bfree} * space.f_frsize;
  }
  return bytes;
}

template <class MemoryOf>
std::uint64_t memory_of(const ProgramTree& tree, const MemoryOf& memory_of_process) {
  std::uint64_t bytes = 0;
  for (const pid_t keeper : tree.keepers) bytes += bytes_in_own_folders(keeper);
  for (const ProcessEntry& process : tree.processes) bytes += memory_of_process(process.pid);
  return bytes;
}

}  // namespace

ProgramUse use_of_programs(std::string_view prefix, std::uint64_t exact_above) {
  const ProgramTree tree = tree_of_programs(prefix);
  ProgramUse use;
  for (const ProcessEntry& process : tree.processes) use.processes += process.threads;

  use.memory = memory_of(tree, private_memory);
  if (use.memory > exact_above) use.memory = memory_of(tree, part_of_memory);
  return use;
}

std::uint64_t unnamed_bytes_of_programs(std::string_view prefix, const std::set<dev_t>& devices) {
  constexpr std::uint64_t kBlock = 512;
  std::set<std::pair<dev_t, ino_t>> counted;
  std::uint64_t bytes = 0;
  for (const ProcessEntry& process : tree_of_programs(prefix).processes) {
    std::error_code code;
    for (fs::directory_iterator entry(folder_of(process.pid) / "fd", code), end;
         !code && entry != end; entry.increment(code)) {
      struct stat file = {};
      if (::stat(entry->path().c_str(), &file) != 0 || !S_ISREG(file.st_mode)) continue;
      if (file.st_nlink != 0 || !devices.contains(file.st_dev)) continue;
      if (!counted.emplace(file.st_dev, file.st_ino).second) continue;
      bytes += static_cast<std::uint64_t>(file.st_blocks) * kBlock;
    }
  }
  return bytes;
}

}  // namespace cls::process
