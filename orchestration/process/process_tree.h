// Who descends from whom, as /proc tells it.
#pragma once

#include <sys/types.h>

#include <vector>

namespace cls::orchestration::process {

/// One process of a tree. A zombie is not listed: it is dead and only waits to be fetched.
struct ProcessEntry {
  pid_t pid = 0;
  pid_t parent = 0;
  double cpu_seconds = 0.0;          ///< its own, in steps of a clock tick (10 ms)
  double fetched_cpu_seconds = 0.0;  ///< of its children that have ended and were waited for
};

/// All living descendants of `root`, itself not among them, parents before children. Empty where
/// there is no /proc.
std::vector<ProcessEntry> descendants_of(pid_t root);

/// CPU time of what descends from `root` and is alive or was waited for by somebody alive; what
/// `root` itself has waited for is not in it.
double living_cpu_seconds(pid_t root);

}  // namespace cls::orchestration::process
