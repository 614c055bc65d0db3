// Limits of the control groups (cgroup v1 and v2) of this process: containers and batch systems set
// them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cls::base {

/// Where the kernel shows control groups; tests have files of their own.
struct ControlGroupFiles {
  std::filesystem::path groups_of_process = "/proc/self/cgroup";
  std::filesystem::path root = "/sys/fs/cgroup";
};

/// The CPU time that the groups allow, in processors, rounded up and at least 1; nothing: no quota.
std::optional<int> processor_quota(const ControlGroupFiles& files = {});

/// The processes and threads that the groups allow (pids.max); nothing: no limit.
std::optional<std::int64_t> process_limit(const ControlGroupFiles& files = {});

/// What the kernel does when memory is short.
struct MemoryKills {
  std::int64_t count = 0;              ///< processes that it has killed in the groups so far
  std::optional<std::uint64_t> limit;  ///< of all memory of a group, in bytes
};
MemoryKills memory_kills(const ControlGroupFiles& files = {});

/// Remembers the count until now; call it before programs start.
void note_memory_kills();

/// "the kernel killed a process for want of memory: its control group allows 60M" if the count has
/// risen since; otherwise empty.
std::string memory_kill_text();

}  // namespace cls::base
