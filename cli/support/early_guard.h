// Starts the guard process for commands that start other programs.
#pragma once

#include <optional>

#include "process/guard.h"

namespace cls::cli {

/// Call first in main, before any thread exists (see process/guard.h). The guard
/// lives as long as the returned object. Returns nothing when fork() fails; a command that needs
/// the guard reports that later.
std::optional<process::Guard> start_early_guard(int argc, char** argv);

}  // namespace cls::cli
