// Starts the guard process for those commands that start other programs.
#pragma once

#include <optional>

#include "orchestration/process/guard.h"

namespace cls::cli {

/// Call first in main, before any thread exists (orchestration/process/guard.h says why); the guard
/// lives as long as the returned object. Nothing for commands that start no programs, and when no
/// process can be made: then the command that needs one says so.
std::optional<orchestration::process::Guard> start_early_guard(int argc, char** argv);

/// True when the command that `argv` names may start other programs.
bool may_start_programs(int argc, const char* const* argv);

}  // namespace cls::cli
