// A keeper: one small process between the guard and one started program.
#pragma once

#include <cstddef>
#include <vector>

#include "base/system/unique_fd.h"
#include "process/command_plan.h"

namespace cls::process {

/// The descriptors of a keeper.
struct KeeperFds {
  base::UniqueFd control;  ///< to cls
  base::UniqueFd output;   ///< of the program
  std::vector<base::UniqueFd> passed;
  base::UniqueFd user;     ///< namespaces to enter; none: no namespaces
  base::UniqueFd network;  ///< with `user`
};

/// Those of a packet with a plan: control, output, `passed` of them, namespaces.
KeeperFds keeper_fds(std::vector<base::UniqueFd> all, std::size_t passed);

/// Enters the namespaces of a program whose keeper will be the next child of this process. On
/// failure reports to cls and exits.
void enter_for_keeper(const KeeperFds& fds);

/// Body of a keeper process: runs the plan and never returns. The keeper is a child subreaper: it
/// adopts every orphan among the program's descendants, so that it can measure their CPU time and
/// terminate all of them. It reports over `control` (packet.h) and handles requests from there.
/// When `control` is closed it terminates everything: SIGTERM, 1 s, SIGKILL. It exits after its
/// last descendant. In namespaces it is the first process, which all others end with, and gives
/// them a root folder of their own.
[[noreturn]] void run_keeper(KeeperFds fds, const CommandPlan& plan);

}  // namespace cls::process
