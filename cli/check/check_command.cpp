// `cls check`: the list of checks.
#include "cli/support/commands.h"

namespace cls::cli {
namespace {

constexpr const char* kCheckDescription =
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
  Command& parent = app.command("check", kCheckDescription);
  parent.group = kCheckCommands;
  parent.starts_programs = true;
  CLS_CHECK_COMMANDS(CLS_ADD_COMMAND)
}

}  // namespace cls::cli
