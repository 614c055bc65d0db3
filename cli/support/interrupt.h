// SIGINT and SIGTERM as a number to look at, so that a match can end in order.
#pragma once

#include <atomic>

namespace cls::cli {

/// Starts to catch SIGINT and SIGTERM and returns where the first of them is noted (0: none came).
/// A second signal of the same kind ends the process the ordinary way.
const std::atomic<int>& watch_interrupts();

}  // namespace cls::cli
