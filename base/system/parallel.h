// The same work for many logs at once.
#pragma once

#include <cstddef>
#include <functional>

namespace cls::base {

/// How many threads to use where the user does not say: one a processor.
std::size_t default_jobs();

/// Calls `work(i)` for all i below `count`, on up to `jobs` threads, in no particular order, and
/// waits for all of them. `on_done`, if any, is called after each with how many are done, on any of
/// the threads. Neither must throw.
void for_each_index(std::size_t count, std::size_t jobs,
                    const std::function<void(std::size_t)>& work,
                    const std::function<void(std::size_t)>& on_done = nullptr);

}  // namespace cls::base
