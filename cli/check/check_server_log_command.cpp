// `cls check server-log GAME.rcg GAME.rcl`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <string>

#include "checks/server_log_check.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::cli {
namespace {

constexpr const char* kCheckServerLogDescription =
    "predict a recorded match step by step with the embedded server\n"
    "\n"
    "  cls check server-log game.rcg.gz game.rcl.gz\n"
    "  cls check server-log game.rcg.gz game.rcl.gz --json\n"
    "\n"
    "Each step starts from the recorded frame (rcg) and executes the recorded\n"
    "commands (rcl). The result is compared with the next frame. Random outcomes\n"
    "(tackle, catch, foul) are taken from the log, and so is noise within its\n"
    "bounds; the distribution of the noise is checked. Reads game logs of versions 4\n"
    "to 6 and JSON, plain or compressed (gzip, xz, zstd).";

struct CheckServerLogArguments {
  std::string game;
  std::string text;
  bool json = false;
};

int run_check_server_log(const CheckServerLogArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto game, gamelog::read_rcg_file(arguments.game));
  TRY_INIT_OR(kNoInput, const auto text, gamelog::read_rcl_file(arguments.text));

  report_errors(arguments.game, game.errors);
  report_errors(arguments.text, text.errors);

  const auto agreement = simulator::replay_log(game, text);
  if (!agreement) {
    print_error(0, "{}: {}", arguments.game, agreement.error().message);
    return kBadData;
  }

  const auto log_checks = checks::log_checks(*agreement);
  fmt::print("{}", arguments.json ? checks::to_json(*agreement, log_checks)
                                  : checks::to_text(*agreement, log_checks));

  if (!checks::passed(log_checks)) return kFailed;
  return game.errors.empty() && text.errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_check_server_log_command(Command& check) {
  auto [command, arguments] =
      check.command("server-log", kCheckServerLogDescription, run_check_server_log);

  command.option("GAME.rcg", arguments.game, "game log of the match").required();
  command.option("GAME.rcl", arguments.text, "its text log").required();
  command.flag("--json", arguments.json, "print one JSON document instead of the report")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
