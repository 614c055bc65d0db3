// The binary `cls`: runs the command line; reports uncaught exceptions as internal errors.
#include <exception>
#include <optional>
#include <string>

#include "base/io/standard_streams.h"
#include "cli/application.h"
#include "cli/support/abort_report.h"
#include "cli/support/finish_output.h"
#include "cli/support/print_error.h"
#include "process/guard.h"
#include "proto/grpc_settings.h"

namespace {

using namespace cls;
using namespace cls::cli;

// The guard of the programs that a command starts, before any thread exists. Nothing if fork()
// fails, which the command reports when it needs the guard.
std::optional<process::Guard> start_guard(const Command& commands, int argc, char** argv) {
  if (!may_start_programs(commands, argc, argv)) return std::nullopt;
  if (auto guard = process::Guard::start(argc, argv)) return *std::move(guard);
  return std::nullopt;
}

// Runs the command and turns exceptions into error lines.
int run(int argc, char** argv) {
  try {
    const auto commands = command_tree();
    const auto guard = start_guard(*commands, argc, argv);
    return run_application(*commands, argc, argv);
  } catch (const std::exception& error) {
    return print_exception(error);
  }
}

// Runs before the initializers of libraries, of which gRPC's open descriptors.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const open_first)() = base::open_standard_descriptors;

}  // namespace

int main(int argc, char** argv) {
  cls::base::protect_standard_streams();
  report_aborts();
  if (const std::string limit = too_low_limit(); !limit.empty()) {
    return print_error(kUnavailable, limit);
  }
  cls::proto::silence_grpc_log();
  return finish_output(run(argc, argv));
}
