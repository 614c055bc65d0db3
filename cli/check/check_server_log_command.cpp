// `cls check server-log GAME.rcg GAME.rcl`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "checks/server_log_check.h"
#include "cli/support/exit_code.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "predict a recorded match step by step with the embedded server\n"
    "\n"
    "  cls check server-log game.rcg.gz game.rcl.gz\n"
    "  cls check server-log game.rcg.gz game.rcl.gz --json\n"
    "\n"
    "Each step starts from the recorded frame (rcg) and executes the recorded\n"
    "commands (rcl). The result is compared with the next frame. Random outcomes\n"
    "(tackle, catch, foul) are taken from the log, and so is noise within its\n"
    "bounds; the distribution of the noise is checked. Reads game logs of versions 4\n"
    "to 6 and JSON, plain or gzip.";

struct Arguments {
  std::string game;
  std::string text;
  bool json = false;
};

int run_check_server_log(const Arguments& arguments) {
  const auto game = gamelog::read_rcg_file(arguments.game);
  if (!game) {
    return print_error(kNoInput, game.error().message);
  }
  const auto text = gamelog::read_rcl_file(arguments.text);
  if (!text) {
    return print_error(kNoInput, text.error().message);
  }

  report_errors(arguments.game, game->errors);
  report_errors(arguments.text, text->errors);

  const auto agreement = simulator::replay_log(*game, *text);
  if (!agreement) {
    print_error(0, fmt::format("{}: {}", arguments.game, agreement.error().message));
    return kBadData;
  }

  const auto log_checks = checks::log_checks(*agreement);
  fmt::print("{}", arguments.json ? checks::to_json(*agreement, log_checks)
                                  : checks::to_text(*agreement, log_checks));

  if (!checks::passed(log_checks)) return kFailed;
  return game->errors.empty() && text->errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_check_server_log_command(Command& check) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = check.command("server-log", kDescription);

  command.option("GAME.rcg", arguments->game, "game log of the match").required();
  command.option("GAME.rcl", arguments->text, "its text log").required();
  command.flag("--json", arguments->json, "print one JSON document instead of the report");
  command.run = [arguments] { return run_check_server_log(*arguments); };
}

}  // namespace cls::cli
