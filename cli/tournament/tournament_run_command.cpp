// `cls tournament run DIR`: plays what is not played yet.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>

#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/tournament_command.h"
#include "cli/tournament/tournament_options.h"
#include "orchestration/tournament/config/config_file.h"
#include "orchestration/tournament/report/report_document.h"
#include "orchestration/tournament/report/report_text.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;

constexpr const char* kDescription =
    "Plays the matches of a tournament that are not played yet.\n"
    "\n"
    "  cls tournament run cup                       with cup/cls.toml, or cls.toml here or above\n"
    "  cls tournament run cup --rounds 10 --seed 3  the command line overrides the file\n"
    "\n"
    "Every result is on disk before the next match begins. Whatever ends a run (Ctrl-C, kill -9, "
    "a\n"
    "power cut): the same command goes on, and plays no finished match twice. A folder with\n"
    "another plan is refused.";

struct Arguments {
  TournamentOptions tournament;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

// The folder made ready: with --force an old tournament gives way, but not its cls.toml.
int make_ready(const Arguments& arguments, const TournamentConfig& config) {
  const fs::path folder = arguments.tournament.folder;
  if (arguments.force && holds_plan(folder)) {
    const auto aside = set_aside(folder);
    if (!aside) return complain(kCannotCreate, aside.error().message);
    fmt::print(stderr, "cls: the old tournament is {} now\n", aside->string());
    std::error_code code;
    fs::create_directories(folder, code);
    if (fs::exists(*aside / kConfigFile, code)) {
      fs::copy_file(*aside / kConfigFile, folder / kConfigFile, code);
    }
  }
  if (const auto ready = prepare_folder(folder, config); !ready) {
    return complain(holds_plan(folder) ? kBadConfig : kCannotCreate, ready.error().message);
  }
  return kDone;
}

int exit_code_of(const RunSummary& summary) {
  switch (summary.end) {
    case RunEnd::kComplete:
    case RunEnd::kDecided:
      return summary.progress.invalid == 0 ? kDone : kAnswerIsNo;
    case RunEnd::kStopRequested:
      return kInterrupted;
    case RunEnd::kInterrupted:
      return summary.signal == SIGTERM ? kTerminated : kInterrupted;
    case RunEnd::kFault:
      return kAnswerIsNo;
  }
  return kInternalError;
}

void tell_end(const RunSummary& summary) {
  if (!summary.message.empty()) complain(0, summary.message);
  if (summary.end == RunEnd::kComplete || summary.end == RunEnd::kDecided) return;
  complain(0, fmt::format("{} of {} matches done ({}); the same command goes on from here",
                          summary.progress.done - (summary.end == RunEnd::kFault ? 1 : 0),
                          summary.progress.total, name(summary.end)));
}

int run(const Arguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kDone) return chosen.exit_code;
  const fs::path folder = arguments.tournament.folder;
  std::error_code code;
  if (holds_plan(folder)) {
    const auto lock = FolderLock::take(folder);
    if (lock && !*lock) {
      return complain(
          kTryAgain, fmt::format("another `cls tournament run` is at work in {}", folder.string()));
    }
  }
  if (const int exit_code = make_ready(arguments, chosen.config); exit_code != kDone) {
    return exit_code;
  }
  const auto lock = FolderLock::take(folder);
  if (!lock) return complain(kCannotCreate, lock.error().message);
  if (!*lock) {
    return complain(kTryAgain,
                    fmt::format("another `cls tournament run` is at work in {}", folder.string()));
  }
  RunOptions options;
  options.folder = folder;
  options.config = chosen.config;
  TournamentProgress progress(stderr_is_terminal() && !arguments.quiet, arguments.quiet);
  const auto make = [&](const TournamentConfig& config) {
    return make_executor(config, folder, own_program());
  };
  const auto summary = run_tournament(options, make, progress, watch_interrupts());
  progress.clear();
  if (!summary) return complain(kWriteFailed, summary.error().message);
  const Report report = make_report(chosen.config, summary->matches, folder);
  fmt::print("{}", arguments.json ? report_json(report) : report_text(report));
  tell_end(*summary);
  return exit_code_of(*summary);
}

}  // namespace

void add_tournament_run_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", kDescription);
  add_tournament_options(*command, arguments->tournament);
  command->add_flag("--force", arguments->force,
                    "begin anew; an old tournament in DIR is kept under a new name");
  command->add_flag("--json", arguments->json, "print the report as JSON, nothing else");
  command->add_flag("--quiet", arguments->quiet, "no progress, no notes");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
