// The tree of commands and how a mistake on the command line is reported.
#include "cli/application.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/version_command.h"

namespace cls::cli {

int run_application(int argc, const char* const* argv) {
  CLI::App app{"cls plays, evaluates and tests RoboCup 2D soccer matches between gRPC Playmakers."};
  app.name("cls");
  app.require_subcommand(1);
  int exit_code = kDone;
  add_version_command(app, exit_code);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    const std::vector<std::string> unknown = app.remaining();
    if (app.get_subcommands().empty() && !unknown.empty()) {
      fmt::print(stderr, "cls: unknown command or option '{}' (see cls --help)\n", unknown.front());
    } else {
      fmt::print(stderr, "cls: {}\n", error.what());
    }
    return kUsage;
  }
  return exit_code;
}

}  // namespace cls::cli
