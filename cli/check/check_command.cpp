// The list of checks.
#include "cli/check/check_command.h"

#include <CLI/CLI.hpp>

#include "cli/check/check_perception_command.h"
#include "cli/check/check_playmaker_command.h"
#include "cli/check/check_server_command.h"
#include "cli/check/check_server_log_command.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "Holds recorded or running things against what they should be.\n"
    "\n"
    "  cls check playmaker localhost:50051\n"
    "  cls check server rcssserver\n"
    "  cls check server-log game.rcg.gz game.rcl.gz\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz\n"
    "\n"
    "The exit code is 0 if the check passed, 1 if it did not.";

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("check", kDescription);
  command->require_subcommand(1);
  add_check_playmaker_command(*command, exit_code);
  add_check_server_command(*command, exit_code);
  add_check_server_log_command(*command, exit_code);
  add_check_perception_command(*command, exit_code);
}

}  // namespace cls::cli
