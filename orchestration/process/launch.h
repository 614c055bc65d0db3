// Starts one program: the only place that knows Boost.Process.
#pragma once

#include <sys/types.h>

#include "orchestration/process/command_plan.h"

namespace cls::orchestration::process {

/// What came of a start. `pid` 0: not started, `error` says why (errno) and `in_folder` whether
/// changing to the working directory failed rather than the program.
struct Launch {
  pid_t pid = 0;
  int error = 0;
  bool in_folder = false;
};

/// Starts the plan's program with `output` as stdout and stderr, in a process group of its own,
/// with no other descriptor than 0, 1 and 2, every signal at its default and none blocked, and
/// such that it dies with the caller. argv[0] must be a path. A script without a first line `#!`
/// is given to /bin/sh, as shells do. Only for a process that has one thread.
Launch launch(const CommandPlan& plan, int output);

}  // namespace cls::orchestration::process
