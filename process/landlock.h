// Landlock: the kernel allows a process and its descendants the use of some files only.
#pragma once

#include "base/result.h"
#include "base/system/unique_fd.h"
#include "process/command_plan.h"

namespace cls::process {

/// The version of Landlock that this process can use; 0: none, because the kernel is older than
/// 5.13, was built or started without it, or a container forbids it.
int landlock_version();

/// A descriptor of the rules for enforce_ruleset(). Paths that do not exist are left out. Since
/// version 6 (Linux 6.12) the rules also forbid signals to processes, and connections to abstract
/// sockets of processes, that they do not hold for. An empty descriptor, with errno set, on
/// failure.
base::UniqueFd make_ruleset(const FileAccess& files);

/// Restricts this process and all its descendants for good; it gains no privileges by set-user-ID
/// programs any more. Async-signal-safe, for use between fork and exec. False with errno set on
/// failure.
bool enforce_ruleset(int ruleset);

}  // namespace cls::process
