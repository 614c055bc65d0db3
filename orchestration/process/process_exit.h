// How a process ended.
#pragma once

#include <string>

namespace cls::orchestration::process {

/// The end of a process as the operating system tells it.
struct ProcessExit {
  bool by_signal = false;
  int number = 0;  ///< exit code, or the signal's number
};

/// "exit code 3" or "killed by SIGSEGV"; "exit code 139 (128 + SIGSEGV)" for what a shell returns
/// when its command was killed.
std::string to_text(const ProcessExit& exit);

/// "SIGTERM" for 15; "signal 77" where there is no name.
std::string signal_name(int number);

}  // namespace cls::orchestration::process
