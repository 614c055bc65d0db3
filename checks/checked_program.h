// Programs started by a check: how they exited.
#pragma once

#include <string>

#include "process/process_host.h"

namespace cls::checks {

/// "WHAT exited (exit code 3); last output line: cannot load the formation"; empty while it runs.
std::string describe_exit(const std::string& what, const process::Child& child);

}  // namespace cls::checks
