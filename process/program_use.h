// What the programs of a side use of this host.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <set>
#include <string_view>

namespace cls::process {

/// Of programs with all their descendants.
struct ProgramUse {
  int processes = 0;         ///< with their threads
  std::uint64_t memory = 0;  ///< bytes: private memory, and files in their folders in memory
};

/// Of the programs that the guard of this process has started and whose names begin with `prefix`.
/// Zero without a guard or /proc. Memory that processes share is counted in each of them, until the
/// sum exceeds `exact_above`: then in parts.
ProgramUse use_of_programs(std::string_view prefix, std::uint64_t exact_above);

/// Bytes of the files on `devices` (of stat) without a name that these programs hold open.
std::uint64_t unnamed_bytes_of_programs(std::string_view prefix, const std::set<dev_t>& devices);

}  // namespace cls::process
