// The whole command line as one function, so that main stays a frame and tests can call it.
#pragma once

namespace cls::cli {

/// Parses `argv`, runs the command it names and returns the exit code (cli/exit_code.h). Results go
/// to stdout, everything else to stderr. Lets exceptions of libraries through.
int run_application(int argc, const char* const* argv);

}  // namespace cls::cli
