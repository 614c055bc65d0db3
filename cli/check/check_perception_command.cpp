// `cls check perception TRANSCRIPT --truth GAME.rcg`.
#include "cli/check/check_perception_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "base/io/byte_source.h"
#include "cli/support/damage_report.h"
#include "cli/support/exit_code.h"
#include "gamelog/rcg/rcg_reader.h"
#include "orchestration/checks/perception_check.h"

namespace cls::cli {
namespace {

constexpr std::size_t kShownDamage = 5;

constexpr const char* kDescription =
    "Measures how far the world model is off on what a real player was told.\n"
    "\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz --json\n"
    "\n"
    "TRANSCRIPT has a line for each datagram of one player: S>C or C>S, seconds, text, separated "
    "by\n"
    "tabs; plain or gzip, - for standard input. It is replayed through the proxy's world model, "
    "and\n"
    "each decision in play_on is compared with the game log: own position and body angle, the "
    "ball\n"
    "and its velocity when just seen, other players when just seen and known by number.";

struct Arguments {
  std::string transcript;
  std::string truth;
  bool json = false;
};

void report_transcript_damage(const std::string& path,
                              const orchestration::checks::PerceptionCheck& check) {
  for (std::size_t i = 0; i < std::min(check.damage.size(), kShownDamage); ++i) {
    fmt::print(stderr, "cls: {}: line {}: {}\n", path, check.damage[i].line, check.damage[i].what);
  }
  if (check.damage.size() > kShownDamage) {
    fmt::print(stderr, "cls: {}: {} more damaged lines\n", path,
               check.damage.size() - kShownDamage);
  }
}

int run_check_perception(const Arguments& arguments) {
  const auto source = base::open_source(arguments.transcript);
  if (!source) {
    fmt::print(stderr, "cls: {}\n", source.error().message);
    return kNoInput;
  }
  const auto log = gamelog::read_rcg_file(arguments.truth);
  if (!log) {
    fmt::print(stderr, "cls: {}\n", log.error().message);
    return kNoInput;
  }
  const std::string transcript = base::read_all(**source);
  const std::string& problem = (*source)->problem();
  if (!problem.empty()) fmt::print(stderr, "cls: {}: {}\n", arguments.transcript, problem);
  report_damage(arguments.truth, log->damage);
  if (log->frames() == 0) return kBadData;
  const auto check = orchestration::checks::check_perception(transcript, *log);
  if (!check) {
    fmt::print(stderr, "cls: {}: {}\n", arguments.transcript, check.error().message);
    return kBadData;
  }
  report_transcript_damage(arguments.transcript, *check);
  fmt::print("{}", arguments.json ? to_json(*check) : to_text(*check));
  return problem.empty() && check->damage.empty() && log->damage.empty() ? kDone : kBadData;
}

}  // namespace

void add_check_perception_command(CLI::App& check, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = check.add_subcommand("perception", kDescription);
  command->add_option("TRANSCRIPT", arguments->transcript, "what one player received and sent")
      ->required();
  command->add_option("--truth", arguments->truth, "game log (rcg) of the match")->required();
  command->add_flag("--json", arguments->json, "one JSON document instead of the table");
  command->callback([arguments, &exit_code] { exit_code = run_check_perception(*arguments); });
}

}  // namespace cls::cli
