// `cls check server-log GAME.rcg GAME.rcl`.
#include "cli/check/check_server_log_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/support/damage_report.h"
#include "cli/support/exit_code.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "orchestration/checks/server_log_check.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "Predicts a soccer server's match one step at a time with the embedded server.\n"
    "\n"
    "  cls check server-log game.rcg.gz game.rcl.gz\n"
    "  cls check server-log game.rcg.gz game.rcl.gz --json\n"
    "\n"
    "Each step starts from the recorded frame (rcg) and takes the recorded commands (rcl); what "
    "comes\n"
    "out is compared with the next frame. Outcomes that the server draws (tackle, catch, foul) "
    "are\n"
    "taken from the record; noise is taken from it as far as its bounds allow, and its "
    "distribution\n"
    "is checked. Game logs of versions 4 to 6 and JSON, plain or gzip.";

struct Arguments {
  std::string game;
  std::string text;
  bool json = false;
};

int run_check_server_log(const Arguments& arguments) {
  const auto game = gamelog::read_rcg_file(arguments.game);
  if (!game) {
    fmt::print(stderr, "cls: {}\n", game.error().message);
    return kNoInput;
  }
  const auto text = gamelog::read_rcl_file(arguments.text);
  if (!text) {
    fmt::print(stderr, "cls: {}\n", text.error().message);
    return kNoInput;
  }
  report_damage(arguments.game, game->damage);
  report_damage(arguments.text, text->damage);
  const auto agreement = simulator::replay_log(*game, *text);
  if (!agreement) {
    fmt::print(stderr, "cls: {}: {}\n", arguments.game, agreement.error().message);
    return kBadData;
  }
  const auto demands = orchestration::checks::demands(*agreement);
  fmt::print("{}", arguments.json ? orchestration::checks::to_json(*agreement, demands)
                                  : orchestration::checks::to_text(*agreement, demands));
  if (!orchestration::checks::passed(demands)) return kAnswerIsNo;
  return game->damage.empty() && text->damage.empty() ? kDone : kBadData;
}

}  // namespace

void add_check_server_log_command(CLI::App& check, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = check.add_subcommand("server-log", kDescription);
  command->add_option("GAME.rcg", arguments->game, "game log of the match")->required();
  command->add_option("GAME.rcl", arguments->text, "its text log")->required();
  command->add_flag("--json", arguments->json, "one JSON document instead of the report");
  command->callback([arguments, &exit_code] { exit_code = run_check_server_log(*arguments); });
}

}  // namespace cls::cli
