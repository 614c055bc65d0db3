// The binary `cls`: runs the command line; reports uncaught exceptions as internal errors.
#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <filesystem>

#include "cli/application.h"
#include "cli/support/early_guard.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "proto/grpc_settings.h"

int main(int argc, char** argv) {
  // A file that reaches the size limit is a failed write like any other and must not kill cls.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    cls::proto::silence_grpc_log();
    const auto guard = cls::cli::start_early_guard(argc, argv);
    return cls::cli::run_application(argc, argv);
  } catch (const std::filesystem::filesystem_error& error) {
    return cls::cli::print_error(
        cls::cli::kNoInput, fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "cls: internal error: {}\n", error.what());
    return cls::cli::kInternalError;
  }
}
