// SIGINT and SIGTERM as a flag to poll, for a graceful shutdown.
#pragma once

#include <atomic>

#include "cli/terminal/exit_code.h"

namespace cls::cli {

/// Installs handlers for SIGINT and SIGTERM. Returns the number of the last signal received (0:
/// none). A second signal of the same kind has its default action.
const std::atomic<int>& watch_interrupts();

/// kTerminated for SIGTERM, otherwise kInterrupted.
ExitCode signal_exit_code(int signal);

}  // namespace cls::cli
