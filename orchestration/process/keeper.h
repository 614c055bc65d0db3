// A keeper: one small process between the guard and one started program.
#pragma once

#include "orchestration/process/command_plan.h"
#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

/// Runs the plan and never returns: the body of a keeper process. All that descends from the
/// program stays below the keeper, which adopts whatever loses its parent; so it knows what
/// belongs to the program, what CPU time it took, and can end all of it. It reports over `control`
/// (packet.h), obeys requests from there, and at end of file, when nobody wants the program any
/// more, ends everything: SIGTERM, 1 s, SIGKILL. It lives as long as anything below it.
[[noreturn]] void run_keeper(UniqueFd control, UniqueFd output, const CommandPlan& plan);

}  // namespace cls::orchestration::process
