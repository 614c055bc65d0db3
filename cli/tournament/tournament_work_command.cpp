// `cls tournament work DIR --index K`: plays one match of a tournament, on any host.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/system/own_program.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/tournament/tournament_options.h"
#include "tournament/report/report_text.h"
#include "tournament/schedule/schedule.h"
#include "tournament/schedule/schedule_check.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_attempt.h"
#include "tournament/store/match_document.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kDescription =
    "play one match of a tournament and write its result to DIR/results\n"
    "\n"
    "  cls tournament work cup --index 17\n"
    "\n"
    "For other hosts that share the folder. Plays nothing if the result exists. `cls\n"
    "tournament run DIR` collects the results. Uses no database.";

struct Arguments {
  TournamentOptions tournament;
  int index = 0;
  int attempt = 1;
  std::string schedule;
  bool json = false;
};

// Creates the plan and the first schedule if the folder has none.
int prepare(const Arguments& arguments) {
  const fs::path folder = arguments.tournament.folder;
  std::error_code code;
  if (holds_plan(folder) && fs::exists(folder / kScheduleFile, code)) return kOk;

  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  if (const auto same = check_plan(folder, chosen.config); !same) {
    return print_error(kBadConfig, same.error().message);
  }
  if (const auto written = write_plan(folder, chosen.config); !written) {
    return print_error(kCannotCreate, written.error().message);
  }

  std::vector<ScheduledMatch> matches;
  for (Fixture& fixture : next_fixtures(chosen.config, {})) {
    matches.push_back(planned(std::move(fixture)));
  }
  const auto written = write_schedule(folder, matches);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

int run(const Arguments& arguments) {
  if (const int exit_code = prepare(arguments); exit_code != kOk) return exit_code;
  const fs::path folder = arguments.tournament.folder;
  const auto fixture = read_fixture(
      arguments.schedule.empty() ? folder / kScheduleFile : fs::path(arguments.schedule),
      arguments.index);
  if (!fixture) return print_error(kNoInput, fixture.error().message);

  const auto config = read_plan(folder);
  if (!config) return print_error(kBadData, config.error().message);
  if (const auto teams = check_teams(*config, *fixture); !teams) {
    return print_error(kBadData, teams.error().message);
  }
  const std::atomic<int>& signal = watch_interrupts();
  const auto program = base::own_program();
  if (!program) return print_error(kUnavailable, program.error().message);

  const auto outcome = work(folder, *fixture, arguments.attempt, *program, signal);
  if (!outcome) return print_error(kWriteFailed, outcome.error().message);
  if (!*outcome) return signal_exit_code(signal);

  if (arguments.json) {
    fmt::print("{}\n", format_work_result(*fixture, **outcome));
  } else {
    ScheduledMatch played = planned(*fixture);
    played.outcome = **outcome;
    fmt::print("{}  {}\n", schedule_text(*config, *fixture), score_text(played));
  }
  if (!(*outcome)->message.empty()) print_error(0, (*outcome)->message);
  return (*outcome)->played() ? kOk : kFailed;
}

}  // namespace

void add_tournament_work_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("work", kDescription);
  command.option("DIR", arguments->tournament.folder, "folder of the tournament").required();
  command.option("--index", arguments->index, "index of the match, from 1").required().above(0);
  command.option("--attempt", arguments->attempt, "number of the attempt").above(0).shows_default();

  command.option("--schedule", arguments->schedule,
                 "file with the line of the match (default: DIR/schedule.jsonl)");
  command.option("--config", arguments->tournament.config_file,
                 "configuration file, if DIR has no plan yet");
  command.flag("--json", arguments->json, "print the result as one JSON document");
  command.run = [arguments] { return run(*arguments); };
}

}  // namespace cls::cli
