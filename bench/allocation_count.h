// How often memory was asked for, by anything in this program.
#pragma once

#include <cstdint>

namespace cls::bench {

/// Calls of operator new so far, on all threads.
std::int64_t allocation_count();

}  // namespace cls::bench
