// The tree of processes, read from /proc.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace cls::process {

/// One process of a tree. Zombies are not listed: they have exited and wait to be reaped.
struct ProcessEntry {
  pid_t pid = 0;
  pid_t parent = 0;
  int threads = 1;
  double cpu_seconds = 0.0;         ///< its own, with a resolution of 10 ms (clock tick)
  double reaped_cpu_seconds = 0.0;  ///< of its children that have exited and were reaped
};

/// A running process; nothing if there is none, or without /proc.
std::optional<ProcessEntry> read_process(pid_t pid);

/// All processes of this host that can be seen, ascending.
std::vector<int> all_pids();

/// The name that ps shows of a process, at most 15 bytes; empty: there is none, or no /proc.
std::string short_name(pid_t pid);

/// All running descendants of `root`, without itself, parents before children. Empty without /proc.
std::vector<ProcessEntry> descendants_of(pid_t root);

/// CPU time of the running descendants of `root` and of what they have reaped; without what `root`
/// itself has reaped.
double living_cpu_seconds(pid_t root);

/// For how long the running descendants of `root`, with all their threads, were ready to run and
/// had no processor. 0 on kernels without this count.
double living_delayed_seconds(pid_t root);

}  // namespace cls::process
