// A parallel for loop.
#pragma once

#include <cstddef>
#include <functional>

namespace cls::base {

/// Default number of threads: one per processor that this process may use, by affinity and by the
/// quota of its control groups.
std::size_t default_jobs();

/// Calls `work(i)` for each i below `count` on up to `jobs` threads, in no particular order, and
/// waits for all. After each call, the same thread calls `on_done` with the number of finished
/// calls. Neither may throw.
void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& on_done = nullptr);

}  // namespace cls::base
