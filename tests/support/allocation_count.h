// How often memory was asked for, by anything in this program.
#pragma once

#include <cstdint>

namespace cls::tests {

/// False under sanitizers, which bring their own allocator: then nothing is counted.
bool counts_allocations();

/// Calls of operator new so far, on all threads.
std::int64_t allocation_count();

}  // namespace cls::tests
