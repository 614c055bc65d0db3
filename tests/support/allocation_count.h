// Counts the memory allocations of this program.
#pragma once

#include <cstdint>

namespace cls::tests {

/// False with sanitizers, which replace the allocator: then nothing is counted.
bool counts_allocations();

/// Calls of operator new so far, on all threads.
std::int64_t allocation_count();

}  // namespace cls::tests
