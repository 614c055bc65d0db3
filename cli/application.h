// The command line as one function that tests can call.
#pragma once

namespace cls::cli {

/// Parses `argv`, runs the command and returns its exit code (cli/support/exit_code.h). Results go
/// to stdout, everything else to stderr. Does not catch exceptions of libraries.
int run_application(int argc, const char* const* argv);

}  // namespace cls::cli
