// The binary `cls`: runs the command line; reports uncaught exceptions as internal errors.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>

#include "cli/application.h"
#include "cli/support/early_guard.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "proto/grpc_settings.h"

namespace {

using namespace cls;
using namespace cls::cli;

// A command whose output is lost has failed, although its work is done.
int finish_output(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  const std::string cause = std::strerror(errno);
  return print_error(exit_code == kOk ? static_cast<int>(kWriteFailed) : exit_code,
                     "cannot write standard output: " + cause);
}

// Runs the command and turns exceptions into error lines.
int run(int argc, char** argv) {
  try {
    const auto commands = command_tree();
    const auto guard = may_start_programs(*commands, argc, argv)
                           ? start_early_guard(argc, argv)
                           : std::optional<orchestration::process::Guard>();
    return run_application(*commands, argc, argv);
  } catch (const std::exception& error) {
    return print_exception(error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A file that reaches the size limit is a failed write like any other and must not kill cls.
  std::signal(SIGXFSZ, SIG_IGN);
  cls::proto::silence_grpc_log();
  return finish_output(run(argc, argv));
}
