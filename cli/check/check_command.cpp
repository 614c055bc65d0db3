// `cls check`: the list of checks.
#include "cli/support/commands.h"

#include <CLI/CLI.hpp>

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "check a Playmaker, a soccer server, its logs or the world model\n"
    "\n"
    "  cls check playmaker localhost:50051\n"
    "  cls check server rcssserver\n"
    "  cls check server-log game.rcg.gz game.rcl.gz\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz\n"
    "\n"
    "Exit code: 0 if the check passed, 1 if it failed.";

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
