// `cls tournament run DIR`: plays the remaining matches.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
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
    "play the remaining matches of a tournament\n"
    "\n"
    "  cls tournament run cup                       with cup/cls.toml, or cls.toml in or above "
    "the\n"
    "                                               working directory\n"
    "  cls tournament run cup --rounds 10 --seed 3  the command line overrides the file\n"
    "\n"
    "Each result is on disk before the next match starts. After any interruption (Ctrl-C,\n"
    "kill -9, power failure) the same command resumes and repeats no finished match. A folder\n"
    "with a different plan is refused.";

struct Arguments {
  TournamentOptions tournament;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

// Prepares the folder. --force moves an old tournament aside, but keeps its cls.toml in place.
int prepare(const Arguments& arguments, const TournamentConfig& config) {
  const fs::path folder = arguments.tournament.folder;
  if (arguments.force && holds_plan(folder)) {
    const auto aside = set_aside(folder);
    if (!aside) return print_error(kCannotCreate, aside.error().message);
    fmt::print(stderr, "cls: old tournament moved to {}\n", aside->string());
    std::error_code code;
    fs::create_directories(folder, code);
    if (fs::exists(*aside / kConfigFile, code)) {
      fs::copy_file(*aside / kConfigFile, folder / kConfigFile, code);
    }
  }
  if (const auto ready = prepare_folder(folder, config); !ready) {
    return print_error(holds_plan(folder) ? kBadConfig : kCannotCreate, ready.error().message);
  }
  return kOk;
}

int exit_code_of(const RunSummary& summary) {
  switch (summary.end) {
    case RunEnd::kComplete:
    case RunEnd::kDecided:
      return summary.progress.invalid == 0 ? kOk : kFailed;
    case RunEnd::kStopRequested:
      return kInterrupted;
    case RunEnd::kInterrupted:
      return signal_exit_code(summary.signal);
    case RunEnd::kFault:
      return kFailed;
  }
  return kInternalError;
}

void print_end(const RunSummary& summary) {
  if (!summary.message.empty()) print_error(0, summary.message);
  if (summary.end == RunEnd::kComplete || summary.end == RunEnd::kDecided) return;
  print_error(0, fmt::format("{} of {} matches done ({}); run the same command to resume",
                             summary.progress.done - (summary.end == RunEnd::kFault ? 1 : 0),
                             summary.progress.total, name(summary.end)));
}

int run(const Arguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  const fs::path folder = arguments.tournament.folder;
  std::error_code code;
  if (holds_plan(folder)) {
    const auto lock = FolderLock::try_lock(folder);
    if (lock && !*lock) {
      return print_error(kTryAgain, fmt::format("{}: another `cls tournament run` is in progress",
                                                folder.string()));
    }
  }
  if (const int exit_code = prepare(arguments, chosen.config); exit_code != kOk) {
    return exit_code;
  }
  const auto lock = FolderLock::try_lock(folder);
  if (!lock) return print_error(kCannotCreate, lock.error().message);
  if (!*lock) {
    return print_error(
        kTryAgain, fmt::format("{}: another `cls tournament run` is in progress", folder.string()));
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
  if (!summary) return print_error(kWriteFailed, summary.error().message);
  const Report report = make_report(chosen.config, summary->matches, folder);
  fmt::print("{}", arguments.json ? report_json(report) : report_text(report));
  print_end(*summary);
  return exit_code_of(*summary);
}

}  // namespace

void add_tournament_run_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", kDescription);
  add_tournament_options(*command, arguments->tournament);
  command->add_flag("--force", arguments->force, "start over; an old tournament in DIR is renamed");
  command->add_flag("--json", arguments->json, "print only the report as JSON");
  command->add_flag("--quiet", arguments->quiet, "print no progress and no notes");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
