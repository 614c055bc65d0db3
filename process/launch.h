// Starts one program; the only file that uses Boost.Process.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "process/command_plan.h"

namespace cls::process {

/// The step at which the start of a program fails.
enum class LaunchStep : std::uint8_t {
  kProgram,  ///< the program itself
  kFolder,   ///< changing to the working directory
  kFiles,    ///< restricting it to its files
  kConfinement,
  kNamespaces,  ///< entering them
  kMounts,      ///< a root folder of its own
};

/// Result of a start. `pid` 0: not started; `error` is the errno of `step`.
struct Launch {
  pid_t pid = 0;
  int error = 0;
  LaunchStep step = LaunchStep::kProgram;
};

/// Starts the plan's program with `output` as stdout and stderr, in its own process group, with
/// only descriptors 0, 1 and 2 open, default signal handlers, no blocked signals and the plan's
/// limits, files and confinement. It is killed when the caller exits. argv[0] must be a path. Runs
/// a script without `#!` line with /bin/sh, as shells do. Only for a single-threaded process.
Launch launch(const CommandPlan& plan, int output);

}  // namespace cls::process
