// `cls check`: the list of checks.
#include "cli/support/commands.h"

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

void add_check_command(Command& app) {
  Command& command = app.command("check", kDescription);
  command.group = kCheckCommands;
  command.starts_programs = true;
  add_check_playmaker_command(command);
  add_check_server_command(command);
  add_check_server_log_command(command);
  add_check_perception_command(command);
}

}  // namespace cls::cli
