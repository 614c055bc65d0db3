// Date, host name, load and processors of this host.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cls::base {

/// "2026-11-21T01:02:03Z".
std::string utc_now();

/// Current time for file and folder names: "20261121T010203Z".
std::string utc_stamp();

std::string host_name();

/// What this host is made of; empty or 0 where unknown.
struct Machine {
  std::string os;      ///< "Debian GNU/Linux 12 (bookworm)"
  std::string kernel;  ///< "Linux 6.1.0"
  std::string cpu;     ///< model name
  int cores = 0;       ///< physical cores this process may run on
  std::int64_t memory_bytes = 0;
};
Machine this_machine();

/// Load average over the last minute; 0 if unknown.
double load_average();

/// "this host is busy: load 54.9 on 2 processors" if twice as many threads want to run as there are
/// processors; otherwise empty.
std::string busy_host();

/// CPU numbers of the affinity mask of this process, ascending; empty if unknown.
std::vector<int> allowed_processors();

/// The allowed hardware threads grouped by physical core: each entry holds the hardware threads of
/// one core.
std::vector<std::vector<int>> allowed_cores();

/// Splits cores into two halves of equal size; the middle one of an odd number belongs to neither.
/// A single core is split by its hardware threads. Empty halves for a single processor.
std::array<std::vector<int>, 2> split_in_half(const std::vector<std::vector<int>>& cores);

/// Number of physical cores this process may run on, no more than the quota of its control groups
/// and at least 1.
int usable_cores();

}  // namespace cls::base
