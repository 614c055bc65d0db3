// `cls stats LOG...`: statistics of each match.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "analysis/statistics/read_statistics.h"
#include "base/system/parallel.h"
#include "base/text/enum_names.h"
#include "cli/logs/counted_logs.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/log_progress.h"
#include "cli/terminal/terminal.h"
#include "gamelog/files/log_files.h"
#include "match/result/recorded_end.h"

namespace cls::cli {
namespace {

using analysis::StatisticsFormat;

constexpr const char* kStatsDescription =
    "print statistics of matches from their logs\n"
    "Possession, passes and who passes to whom, shots, tackles, territory, set\n"
    "plays, positions, distance and stamina; with the text log (rcl) beside the game\n"
    "log also the responsiveness of the players.\n"
    "\n"
    "  cls stats game.rcg.gz                  teams and players\n"
    "  cls stats game.rcg --json --events     all, with each pass and shot\n"
    "  cls stats runs/ --format csv           one row per team and match\n"
    "  cls stats runs/ --format spadl         actions, as socceraction reads them\n"
    "\n"
    "LOG is a game log (rcg), a folder, a pattern, or - for standard input.";

struct StatsArguments {
  std::vector<std::string> logs;
  std::string format = "text";
  bool json = false;
  bool events = false;
  std::size_t jobs = base::default_jobs();
};

constexpr auto kStatisticsFormats =
    base::enum_names<StatisticsFormat>("text", "json", "csv", "csv-players", "csv-events", "spadl");

analysis::StatisticsOutput read_all(const std::vector<gamelog::MatchLogs>& matches,
                                    StatisticsFormat format, const StatsArguments& arguments) {
  LogProgress progress(matches.size());
  return read_statistics(
      match::with_recorded_ends(matches), format, arguments.events, arguments.jobs,
      [&](std::size_t count) { progress.update(count); }, stdout_width());
}

int run_stats_command(const StatsArguments& arguments) {
  const auto format = kStatisticsFormats.parse(arguments.json ? "json" : arguments.format);
  if (!format) {
    return print_error(kUsage,
                       "--format '{}': must be text, json, csv, csv-players, csv-events or spadl",
                       arguments.format);
  }

  const gamelog::FoundLogs found = find_counted_logs(arguments.logs);
  int exit_code = report_missing(found);
  const analysis::StatisticsOutput output = read_all(found.matches, *format, arguments);
  for (const analysis::LogProblem& problem : output.problems) {
    exit_code = report_log(exit_code, problem.unreadable, problem.file, problem.errors);
  }

  fmt::print("{}", output.text);
  return exit_code;
}

}  // namespace

void add_stats_command(Command& app) {
  auto [command, arguments] = app.command("stats", kStatsDescription, run_stats_command);
  command.group = kResultCommands;
  command.option("LOG", arguments.logs, "game logs, folders or patterns").required();
  command
      .setting("--format FORMAT", arguments.format,
               "text, json, csv (teams), csv-players, csv-events or spadl")
      .of_group(kOutputGroup);

  command.flag("--json", arguments.json, "the same as --format json").of_group(kOutputGroup);
  command.flag("--events", arguments.events,
               "with JSON: list each pass, shot, tackle and foul (spadl always does)");
  command
      .option("--jobs", arguments.jobs, "logs read in parallel (default: one per processor core)")
      .above(0);
}

}  // namespace cls::cli
