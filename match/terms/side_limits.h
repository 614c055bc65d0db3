// What the programs of a side may use of the host together.
#pragma once

#include <cstdint>

namespace cls::match {

struct SideLimits {
  int processes = 4096;                         ///< with their threads
  std::uint64_t memory = 0;                     ///< bytes; 0: two fifths of the memory of this host
  std::uint64_t disk = std::uint64_t{1} << 30;  ///< bytes that they may add
};

}  // namespace cls::match
