// `cls version` prints one line: the name and the release.
#include "cli/version_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "base/system/version.h"
#include "cli/support/exit_code.h"

namespace cls::cli {

void add_version_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("version", "Prints the version.");
  command->callback([&exit_code] {
    fmt::print("cls {}\n", base::kVersion);
    exit_code = kDone;
  });
}

}  // namespace cls::cli
