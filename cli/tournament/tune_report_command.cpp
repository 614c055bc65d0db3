// `cls tune report DIR` and `cls tune status DIR`: what a search found so far.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "base/io/whole_file.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tune_session.h"

namespace cls::cli {
namespace {

using namespace tournament;

constexpr const char* kTuneReportDescription =
    "print the values found so far, also while a search runs\n"
    "\n"
    "  cls tune report DIR                      values, their difference, the verdict\n"
    "  cls tune report DIR --picture found.svg  scores and values by generation\n"
    "  cls tune report DIR --json               all candidates with their scores";

constexpr const char* kTuneStatusDescription =
    "print the last finished generation in one line\n"
    "\n"
    "  cls tune status DIR    its score with its interval, and the best values";

struct TuneReportArguments {
  std::string folder;
  std::string picture;
  bool json = false;
};

// The finished generations. Prints errors; returns an exit code.
int read_search(const std::string& folder, std::optional<Tuning>& tuning) {
  TuneConfig config;
  TRY_STEP(read_tune_config(folder, config));
  tuning.emplace(std::move(config));
  TRY_OR(kBadData, replay_generations(*tuning, folder));
  if (!tuning->history().empty()) return kOk;
  return print_error(kNoInput,
                     "{}: no generation is finished; `cls tune run {}` plays "
                     "them",
                     folder, folder);
}

int run_tune_status(const TuneReportArguments& arguments) {
  std::optional<Tuning> tuning;
  TRY_STEP(read_search(arguments.folder, tuning));

  fmt::print("{}", arguments.json
                       ? tune_json(*tuning, known_verdict(tuning->config(), arguments.folder))
                       : generation_line(*tuning) + "\n");
  return kOk;
}

int run_tune_report(const TuneReportArguments& arguments) {
  std::optional<Tuning> tuning;
  TRY_STEP(read_search(arguments.folder, tuning));

  if (!arguments.picture.empty()) {
    TRY_OR(kCannotCreate, base::write_file(arguments.picture, tune_picture(*tuning)));
  }

  const auto verdict = known_verdict(tuning->config(), arguments.folder);
  fmt::print("{}", arguments.json ? tune_json(*tuning, verdict)
                                  : tune_text(*tuning, verdict, stdout_width()));
  return kOk;
}

}  // namespace

void add_tune_status_command(Command& app) {
  auto [command, arguments] = app.command("status", kTuneStatusDescription, run_tune_status);
  command.option("DIR", arguments.folder, "folder of tune.toml").required();
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

void add_tune_report_command(Command& app) {
  auto [command, arguments] = app.command("report", kTuneReportDescription, run_tune_report);
  command.option("DIR", arguments.folder, "folder of tune.toml").required();
  command.option("--picture", arguments.picture, "write an SVG image to FILE").placeholder("FILE");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
