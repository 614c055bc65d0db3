// `cls check perception TRANSCRIPT --truth GAME.rcg`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/io/byte_source.h"
#include "base/io/whole_file.h"
#include "checks/perception_check.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_reader.h"
#include "match/hooks/world_model_sample.h"
#include "soccer/side.h"
#include "viewer/decisions/decision_writer.h"
#include "viewer/page/encoding.h"
#include "viewer/page/match_page.h"

namespace cls::cli {
namespace {

constexpr std::size_t kMaxShownErrors = 5;

constexpr const char* kCheckPerceptionDescription =
    "measure the accuracy of the world model on a recorded player\n"
    "\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz --json\n"
    "  cls check perception player_7.txt.gz --truth game.rcg.gz --page game.html\n"
    "\n"
    "TRANSCRIPT has a line per datagram of one player: S>C or C>S, seconds, text,\n"
    "separated by tabs; plain or compressed, - for standard input. It is replayed\n"
    "through the world model. Each decision in play_on is compared with the game\n"
    "log: own position and body angle, the ball and its velocity when just seen,\n"
    "other players when just seen with their uniform number.";

struct CheckPerceptionArguments {
  std::string transcript;
  std::string truth;
  std::string page;
  bool json = false;
};

void report_transcript_errors(const std::string& path, const checks::PerceptionCheck& check) {
  for (std::size_t i = 0; i < std::min(check.damage.size(), kMaxShownErrors); ++i) {
    print_error(0, "{}: line {}: {}", path, check.damage[i].line, check.damage[i].what);
  }

  if (check.damage.size() > kMaxShownErrors) {
    print_error(0, "{}: {} more errors", path, check.damage.size() - kMaxShownErrors);
  }
}

// The page of the match with what the player estimated.
base::Result<void> write_page(const CheckPerceptionArguments& arguments,
                              const gamelog::MatchRecord& log, const checks::PerceptionCheck& check,
                              const std::vector<viewer::DecisionSample>& samples) {
  std::string stream;

  viewer::DecisionWriter writer;
  writer.append_header(check.side, check.team, stream);
  for (const viewer::DecisionSample& sample : samples) writer.append(check.unum, sample, stream);
  writer.append_end(stream);

  const std::string player = soccer::letter(check.side) + std::to_string(check.unum);
  const std::string file = std::filesystem::path(arguments.truth).filename().string();
  return base::write_file(arguments.page,
                          viewer::match_page(log, nullptr, file,
                                             {.settings = {.players = {player}},
                                              .decisions = {{check.side, viewer::gzip(stream)}}}));
}

int run_check_perception(const CheckPerceptionArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto source, base::open_source(arguments.transcript));

  TRY_INIT_OR(kNoInput, const auto log, gamelog::read_rcg_file(arguments.truth));

  const std::string transcript = base::read_all(*source);
  const std::string& problem = source->error();
  if (!problem.empty()) print_error(0, "{}: {}", arguments.transcript, problem);
  report_errors(arguments.truth, log.errors);
  if (log.frames() == 0) return kBadData;

  std::vector<viewer::DecisionSample> samples;
  const auto check = checks::check_perception(
      transcript, log,
      [&samples](const player::WorldModel& world) { samples.push_back(match::sample_of(world)); });

  if (!check) {
    print_error(0, "{}: {}", arguments.transcript, check.error().message);
    return kBadData;
  }

  report_transcript_errors(arguments.transcript, *check);
  if (!arguments.page.empty()) {
    TRY_OR(kCannotCreate, write_page(arguments, log, *check, samples));
  }

  fmt::print("{}", arguments.json ? to_json(*check) : to_text(*check));
  return problem.empty() && check->damage.empty() && log.errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_check_perception_command(Command& check) {
  auto [command, arguments] =
      check.command("perception", kCheckPerceptionDescription, run_check_perception);

  command.option("TRANSCRIPT", arguments.transcript, "datagrams of one player").required();
  command.option("--truth FILE", arguments.truth, "game log (rcg) of the match").required();
  command
      .option("--page FILE", arguments.page,
              "also write a page of the match with the decision debugger of the player")
      .of_group(kOutputGroup);

  command.flag("--json", arguments.json, "print one JSON document instead of the table")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
