// Exit status of a process.
#pragma once

#include <string>

namespace cls::process {

/// Exit status as reported by the kernel.
struct ProcessExit {
  bool by_signal = false;
  int number = 0;  ///< exit code, or the signal's number
};

/// "exit code 3" or "killed by SIGSEGV"; "exit code 139 (128 + SIGSEGV)" for the exit code
/// of a shell whose command was killed.
std::string to_text(const ProcessExit& exit);

/// "SIGTERM" for 15; "signal 77" without a name.
std::string signal_name(int number);

}  // namespace cls::process
