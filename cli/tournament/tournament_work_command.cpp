// `cls tournament work DIR --index K`: plays one match of a tournament, wherever this runs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>

#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/tournament/tournament_command.h"
#include "cli/tournament/tournament_options.h"
#include "orchestration/tournament/report/report_text.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/store/collector.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;

constexpr const char* kDescription =
    "Plays one match of a tournament and leaves its result in DIR/results.\n"
    "\n"
    "  cls tournament work cup --index 17\n"
    "\n"
    "For other machines that see the folder: nothing is played when the result is there already, "
    "and\n"
    "`cls tournament run DIR` takes the results up. It needs no database.";

struct Arguments {
  TournamentOptions tournament;
  int index = 0;
  int attempt = 1;
  std::string schedule;
};

// A folder that was never run gets its plan and first schedule now.
int make_ready(const Arguments& arguments) {
  const fs::path folder = arguments.tournament.folder;
  std::error_code code;
  if (holds_plan(folder) && fs::exists(folder / kScheduleFile, code)) return kDone;
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kDone) return chosen.exit_code;
  if (const auto ready = prepare_folder(folder, chosen.config); !ready) {
    return complain(holds_plan(folder) ? kBadConfig : kCannotCreate, ready.error().message);
  }
  std::vector<ScheduledMatch> matches;
  for (Fixture& fixture : next_fixtures(chosen.config, {})) {
    matches.push_back(planned(std::move(fixture)));
  }
  const auto written = write_schedule(folder, matches);
  return written ? kDone : complain(kCannotCreate, written.error().message);
}

int run(const Arguments& arguments) {
  if (const int exit_code = make_ready(arguments); exit_code != kDone) return exit_code;
  const fs::path folder = arguments.tournament.folder;
  const auto fixture = read_fixture(
      arguments.schedule.empty() ? folder / kScheduleFile : fs::path(arguments.schedule),
      arguments.index);
  if (!fixture) return complain(kNoInput, fixture.error().message);
  const std::atomic<int>& signal = watch_interrupts();
  const auto outcome = work(folder, *fixture, arguments.attempt, own_program(), signal);
  if (!outcome) return complain(kWriteFailed, outcome.error().message);
  if (!*outcome) return signal == SIGTERM ? kTerminated : kInterrupted;
  const auto config = read_plan(folder);
  if (config) {
    ScheduledMatch played = planned(*fixture);
    played.outcome = **outcome;
    fmt::print("{}  {}\n", schedule_text(*config, *fixture), score_text(played));
  }
  if (!(*outcome)->message.empty()) complain(0, (*outcome)->message);
  return (*outcome)->played() ? kDone : kAnswerIsNo;
}

}  // namespace

void add_tournament_work_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("work", kDescription);
  command->add_option("DIR", arguments->tournament.folder, "the tournament's folder")->required();
  command->add_option("--index", arguments->index, "number of the match, from 1")
      ->required()
      ->check(CLI::PositiveNumber);
  command->add_option("--attempt", arguments->attempt, "number of the attempt (1)")
      ->check(CLI::PositiveNumber);
  command->add_option("--schedule", arguments->schedule,
                      "file with the match's line (DIR/schedule.jsonl)");
  command->add_option("--config", arguments->tournament.config_file,
                      "configuration, where DIR holds no plan yet");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace cls::cli
