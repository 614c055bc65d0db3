// Ends of processes that a limit of the match explains (`--max-memory`, `--max-cpu`).
#pragma once

#include <string>

#include "process/process_host.h"

namespace cls::match {

/// To be appended to the message about a process that failed: "; a process of left Playmaker had
/// used the 10 s of CPU time that --max-cpu allows: raise or omit the limit". Empty if no limit
/// explains the end.
/// The kernel reports the end by the limit of CPU time. A program that gets no more memory ends in
/// its own way: then the hint follows from its last output lines.
std::string limit_hint(const process::Child& child);

}  // namespace cls::match
