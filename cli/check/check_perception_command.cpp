// `cls check perception TRANSCRIPT --truth GAME.rcg`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "base/io/byte_source.h"
#include "cli/support/exit_code.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_reader.h"
#include "orchestration/checks/perception_check.h"

namespace cls::cli {
namespace {

constexpr std::size_t kMaxShownErrors = 5;

constexpr const char* kDescription =
    "measure the accuracy of the world model on a recorded player\n"
    "\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz --json\n"
    "\n"
    "TRANSCRIPT has a line per datagram of one player: S>C or C>S, seconds, text,\n"
    "separated by tabs; plain or gzip, - for standard input. It is replayed through\n"
    "the world model. Each decision in play_on is compared with the game log: own\n"
    "position and body angle, the ball and its velocity when just seen, other\n"
    "players when just seen with their uniform number.";

struct Arguments {
  std::string transcript;
  std::string truth;
  bool json = false;
};

void report_transcript_errors(const std::string& path,
                              const orchestration::checks::PerceptionCheck& check) {
  for (std::size_t i = 0; i < std::min(check.damage.size(), kMaxShownErrors); ++i) {
    print_error(0,
                fmt::format("{}: line {}: {}", path, check.damage[i].line, check.damage[i].what));
  }
  if (check.damage.size() > kMaxShownErrors) {
    print_error(0, fmt::format("{}: {} more errors", path, check.damage.size() - kMaxShownErrors));
  }
}

int run_check_perception(const Arguments& arguments) {
  const auto source = base::open_source(arguments.transcript);
  if (!source) {
    return print_error(kNoInput, source.error().message);
  }
  const auto log = gamelog::read_rcg_file(arguments.truth);
  if (!log) {
    return print_error(kNoInput, log.error().message);
  }
  const std::string transcript = base::read_all(**source);
  const std::string& problem = (*source)->error();
  if (!problem.empty()) print_error(0, fmt::format("{}: {}", arguments.transcript, problem));
  report_errors(arguments.truth, log->errors);
  if (log->frames() == 0) return kBadData;
  const auto check = orchestration::checks::check_perception(transcript, *log);
  if (!check) {
    print_error(0, fmt::format("{}: {}", arguments.transcript, check.error().message));
    return kBadData;
  }
  report_transcript_errors(arguments.transcript, *check);
  fmt::print("{}", arguments.json ? to_json(*check) : to_text(*check));
  return problem.empty() && check->damage.empty() && log->errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_check_perception_command(CLI::App& check, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = check.add_subcommand("perception", kDescription);
  command->add_option("TRANSCRIPT", arguments->transcript, "datagrams of one player")->required();
  command->add_option("--truth", arguments->truth, "game log (rcg) of the match")->required();
  command->add_flag("--json", arguments->json, "print one JSON document instead of the table");
  command->callback([arguments, &exit_code] { exit_code = run_check_perception(*arguments); });
}

}  // namespace cls::cli
