// `cls tune report DIR` and `cls tune status DIR`: what a search found so far.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/io/whole_file.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tune_session.h"

namespace cls::cli {
namespace {

using namespace tournament;

constexpr const char* kDescription =
    "print the values found so far, also while a search runs\n"
    "\n"
    "  cls tune report DIR                      values, their difference, the verdict\n"
    "  cls tune report DIR --picture found.svg  scores and values by generation\n"
    "  cls tune report DIR --json               all candidates with their scores";

constexpr const char* kStatusDescription =
    "print the last finished generation in one line\n"
    "\n"
    "  cls tune status DIR    its score with its interval, and the best values";

struct Arguments {
  std::string folder;
  std::string picture;
  bool json = false;
};

// The finished generations. Prints errors; returns an exit code.
int read_search(const std::string& folder, std::optional<Tuning>& tuning) {
  TuneConfig config;
  if (const int code = read_tune_config(folder, config); code != kOk) return code;
  tuning.emplace(std::move(config));
  if (const auto replayed = replay_generations(*tuning, folder); !replayed) {
    return print_error(kBadData, replayed.error().message);
  }
  if (!tuning->history().empty()) return kOk;
  return print_error(kNoInput, fmt::format("{}: no generation is finished; `cls tune run {}` plays "
                                           "them",
                                           folder, folder));
}

int status(const Arguments& arguments) {
  std::optional<Tuning> tuning;
  if (const int code = read_search(arguments.folder, tuning); code != kOk) return code;

  fmt::print("{}", arguments.json
                       ? tune_json(*tuning, known_verdict(tuning->config(), arguments.folder))
                       : generation_line(*tuning) + "\n");
  return kOk;
}

int report(const Arguments& arguments) {
  std::optional<Tuning> tuning;
  if (const int code = read_search(arguments.folder, tuning); code != kOk) return code;

  if (!arguments.picture.empty()) {
    const auto written = base::write_file(arguments.picture, tune_picture(*tuning));
    if (!written) return print_error(kCannotCreate, written.error().message);
  }

  const auto verdict = known_verdict(tuning->config(), arguments.folder);
  fmt::print("{}", arguments.json ? tune_json(*tuning, verdict)
                                  : tune_text(*tuning, verdict, stdout_width()));
  return kOk;
}

}  // namespace

void add_tune_status_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("status", kStatusDescription);
  command.option("DIR", arguments->folder, "folder of tune.toml").required();
  command.flag("--json", arguments->json, "print one JSON document");
  command.run = [arguments] { return status(*arguments); };
}

void add_tune_report_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("report", kDescription);
  command.option("DIR", arguments->folder, "folder of tune.toml").required();
  command.option("--picture", arguments->picture, "write an SVG image to FILE").placeholder("FILE");
  command.flag("--json", arguments->json, "print one JSON document");
  command.run = [arguments] { return report(*arguments); };
}

}  // namespace cls::cli
