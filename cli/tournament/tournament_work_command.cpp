// `cls tournament work DIR --index K`: plays one match of a tournament, on any host.
#include <fmt/format.h>

#include <string>

#include "base/system/own_program.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/tournament/tournament_options.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tournament/report/report_text.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_attempt.h"
#include "tournament/store/match_document.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kWorkDescription =
    "play one match of a tournament and write its result to DIR/results\n"
    "\n"
    "  cls tournament work cup --index 17\n"
    "\n"
    "For other hosts that share the folder. Plays nothing if the result exists. `cls\n"
    "tournament run DIR` collects the results. Uses no database.";

struct WorkArguments {
  TournamentOptions tournament;
  int index = 0;
  int attempt = 1;
  std::string schedule;
  bool json = false;
};

// Creates the plan and the first schedule if the folder has none.
int prepare(const WorkArguments& arguments) {
  const fs::path folder = arguments.tournament.folder;
  std::error_code code;
  if (holds_plan(folder) && fs::exists(folder / kScheduleFile, code)) return kOk;

  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  TRY_OR(kBadConfig, check_plan(folder, chosen.config));
  TRY_OR(kCannotCreate, write_plan(folder, chosen.config));

  std::vector<ScheduledMatch> matches;
  for (Fixture& fixture : next_fixtures(chosen.config.competition, {})) {
    matches.push_back(planned(std::move(fixture)));
  }
  const auto written = write_schedule(folder, matches);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

int run_work(const WorkArguments& arguments) {
  TRY_STEP(prepare(arguments));
  const fs::path folder = arguments.tournament.folder;
  TRY_INIT_OR(kNoInput, const auto fixture,
              read_fixture(arguments.schedule.empty() ? folder / kScheduleFile
                                                      : fs::path(arguments.schedule),
                           arguments.index));

  TRY_INIT_OR(kBadData, const auto config, read_plan(folder));
  TRY_OR(kBadData, check_teams(config.competition, fixture));
  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());

  TRY_INIT_OR(kWriteFailed, const auto outcome,
              work(folder, fixture, arguments.attempt, program, signal));
  if (!outcome) return signal_exit_code(signal);

  if (arguments.json) {
    fmt::print("{}\n", format_work_result(fixture, *outcome));
  } else {
    ScheduledMatch played = planned(fixture);
    played.outcome = *outcome;
    fmt::print("{}  {}\n", schedule_text(config, fixture), score_text(played));
  }
  if (!outcome->message.empty()) print_error(0, outcome->message);
  return outcome->played() ? kOk : kFailed;
}

}  // namespace

void add_tournament_work_command(Command& app) {
  auto [command, arguments] = app.command("work", kWorkDescription, run_work);
  command.option("DIR", arguments.tournament.folder, "folder of the tournament").required();
  command.option("--index", arguments.index, "index of the match, from 1").required().above(0);
  command.setting("--attempt", arguments.attempt, "number of the attempt").above(0);

  command.option("--schedule", arguments.schedule,
                 "file with the line of the match (default: DIR/schedule.jsonl)");
  command.option("--config FILE", arguments.tournament.config_file,
                 "configuration file, if DIR has no plan yet");
  command.flag("--json", arguments.json, "print the result as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
