// A keeper: one small process between the guard and one started program.
#pragma once

#include "base/system/unique_fd.h"
#include "process/command_plan.h"

namespace cls::process {

/// Body of a keeper process: runs the plan and never returns. The keeper is a child subreaper: it
/// adopts every orphan among the program's descendants, so that it can measure their CPU time and
/// terminate all of them. It reports over `control` (packet.h) and handles requests from there.
/// When `control` is closed it terminates everything: SIGTERM, 1 s, SIGKILL. It exits after its
/// last descendant.
[[noreturn]] void run_keeper(base::UniqueFd control, base::UniqueFd output,
                             const CommandPlan& plan);

}  // namespace cls::process
