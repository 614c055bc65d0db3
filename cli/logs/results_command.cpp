// `cls results LOG...`: a row per match and the standings.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "analysis/results/read_results.h"
#include "analysis/results/results_text.h"
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

using analysis::ReadResult;
using analysis::ResultsFormat;

constexpr const char* kResultsDescription =
    "print the results of matches from their logs\n"
    "Score, goals with cycle and scorer, cards, substitutions and disconnected\n"
    "players; for several logs the standings too.\n"
    "\n"
    "  cls results game.rcg.gz\n"
    "  cls results runs/ --format markdown\n"
    "  cls results 'logs/*.rcg' --json\n"
    "\n"
    "LOG is a game log (rcg), a text log (rcl), a folder, a pattern, or - for\n"
    "standard input. A log without time_over is \"incomplete\". A result.json of cls\n"
    "match beside the log takes precedence: a match ended by --cycles is finished.\n"
    "Format of goals: \"cycle side unum\", as in 169 l 11.";

struct ResultsArguments {
  std::vector<std::string> logs;
  std::string format = "table";
  bool json = false;
  std::size_t jobs = base::default_jobs();
};

constexpr auto kResultFormats = base::enum_names<ResultsFormat>("table", "json", "csv", "markdown");

std::vector<ReadResult> read_all(const std::vector<gamelog::MatchLogs>& matches, std::size_t jobs) {
  LogProgress progress(matches.size());
  return analysis::read_results(match::with_recorded_ends(matches), jobs,
                                [&](std::size_t count) { progress.update(count); });
}

int run_results_command(const ResultsArguments& arguments) {
  const auto format = kResultFormats.parse(arguments.json ? "json" : arguments.format);
  if (!format) {
    return print_error(kUsage, "--format '{}': must be table, json, csv or markdown",
                       arguments.format);
  }

  const gamelog::FoundLogs found = find_counted_logs(arguments.logs);
  int exit_code = report_missing(found);
  std::vector<analysis::MatchSummary> summaries;
  for (ReadResult& result : read_all(found.matches, arguments.jobs)) {
    exit_code = report_log(exit_code, result.unreadable, result.error_file, result.errors);
    if (result.usable) summaries.push_back(std::move(result.summary));
  }

  if (!summaries.empty() || *format == ResultsFormat::kJson) {
    // Names of logs are cut on a terminal only: in a pipe or file they are used.
    const std::size_t width = stdout_is_terminal() ? stdout_width() : 0;
    fmt::print("{}", format_results(summaries, *format, width));
  }

  return exit_code;
}

}  // namespace

void add_results_command(Command& app) {
  auto [command, arguments] = app.command("results", kResultsDescription, run_results_command);
  command.group = kResultCommands;

  command.option("LOG", arguments.logs, "logs, folders or patterns").required();
  command.setting("--format FORMAT", arguments.format, "table, json, csv or markdown")
      .of_group(kOutputGroup);
  command.flag("--json", arguments.json, "the same as --format json").of_group(kOutputGroup);
  command
      .option("--jobs", arguments.jobs, "logs read in parallel (default: one per processor core)")
      .above(0);
}

}  // namespace cls::cli
