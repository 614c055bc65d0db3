// Starts one program; the only file that uses Boost.Process.
#pragma once

#include <sys/types.h>

#include "orchestration/process/command_plan.h"

namespace cls::orchestration::process {

/// Result of a start. `pid` 0: not started; `error` is the errno, `in_folder` is true when changing
/// to the working directory failed.
struct Launch {
  pid_t pid = 0;
  int error = 0;
  bool in_folder = false;
};

/// Starts the plan's program with `output` as stdout and stderr, in its own process group, with
/// only descriptors 0, 1 and 2 open, default signal handlers, no blocked signals and the plan's
/// limits. It is killed when the caller exits. argv[0] must be a path. Runs a script without `#!`
/// line with /bin/sh, as shells do. Only for a single-threaded process.
Launch launch(const CommandPlan& plan, int output);

}  // namespace cls::orchestration::process
