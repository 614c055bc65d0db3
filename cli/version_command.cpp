// `cls version`.
#include "cli/support/commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "base/system/version.h"
#include "cli/support/exit_code.h"

namespace cls::cli {

void add_version_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("version", "print the version");
  command->callback([&exit_code] {
    fmt::print("cls {}\n", base::kVersion);
    exit_code = kOk;
  });
}

}  // namespace cls::cli
