// Short programs whose output a command reads.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// Runs a program to its end and returns the lines that it printed, of stdout and stderr. `argv`
/// has the program, then its arguments. The error begins with `name` and has its last line: it
/// cannot be started, has failed, or took longer than `limit`. Only in commands that may start
/// programs.
base::Result<std::vector<std::string>> run_program(
    const std::string& name, std::vector<std::string> argv,
    std::chrono::seconds limit = std::chrono::seconds(120));

}  // namespace cls::cli
