// The command line as functions that tests can call.
#pragma once

#include <memory>

#include "cli/command/command.h"

namespace cls::cli {

/// `cls` and all its commands.
std::unique_ptr<Command> command_tree();

/// True when the command that `argv` names may start other programs, and needs a guard.
bool may_start_programs(const Command& root, int argc, const char* const* argv);

/// Parses `argv`, runs the command and returns its exit code (cli/terminal/exit_code.h). Results go
/// to stdout, everything else to stderr. Does not catch exceptions of libraries.
int run_application(Command& root, int argc, const char* const* argv);

}  // namespace cls::cli
