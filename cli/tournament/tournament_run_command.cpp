// `cls tournament run DIR`: plays the remaining matches.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/text/suggestion.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "cli/terminal/tournament_progress.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tournament/config/config_file.h"
#include "tournament/report/report_document.h"
#include "tournament/report/report_text.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kTournamentRunDescription =
    "play the remaining matches of a tournament\n"
    "\n"
    "  cls tournament run cup              with cup/cls.toml, or cls.toml in or above\n"
    "                                      the working directory\n"
    "  cls tournament run cup --rounds 10  the command line overrides the file\n"
    "  cls tournament run cup --results FILE     matches that were played elsewhere\n"
    "\n"
    "Each result is on disk before the next match starts. After any interruption\n"
    "(Ctrl-C, kill -9, power failure) the same command resumes and repeats no\n"
    "finished match. A folder with a different plan is refused.";

struct TournamentRunArguments {
  TournamentOptions tournament;
  SessionOptions session;
  std::string results;
  bool report = true;  ///< print it
};

// Matches of later rounds are unknown as long as earlier ones are not played.
std::size_t matches_to_play(const TournamentConfig& config,
                            const std::vector<ScheduledMatch>& matches) {
  const auto open = static_cast<std::size_t>(count(matches).open);
  return open > 0 ? open : next_fixtures(config.competition, matches).size();
}

// A mistyped name begins another tournament where the working directory has a configuration.
void suggest_begun_one(const fs::path& folder) {
  std::error_code code;
  if (holds_plan(folder) || fs::exists(folder / kConfigFile, code)) return;
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path named = whole.has_filename() ? whole : whole.parent_path();
  std::vector<std::string> begun;
  for (fs::directory_iterator at(named.parent_path(), code), end; !code && at != end;
       at.increment(code)) {
    if (holds_plan(at->path())) begun.push_back(at->path().filename().string());
  }

  const std::string hint =
      base::did_you_mean(named.filename().string(), {begun.begin(), begun.end()});
  if (!hint.empty()) fmt::print(stderr, "cls: {}: a new tournament{}\n", folder.string(), hint);
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

int run_tournament_command(const TournamentRunArguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;

  const fs::path folder = arguments.tournament.folder;
  SessionOptions session = arguments.session;
  if (!arguments.results.empty()) session.no_preflight = true;  // no team starts
  const auto outlook_of = [&chosen](const std::vector<ScheduledMatch>& matches) {
    const std::size_t to_play = matches_to_play(chosen.config, matches);
    return Outlook{static_cast<double>(to_play), fmt::format("{} matches to play", to_play)};
  };
  if (!session.quiet) suggest_begun_one(folder);
  const OpenedFolder opened = begin_session(folder, chosen.config, session, outlook_of);
  if (opened.exit_code != kOk) return opened.exit_code;

  if (const auto checked = check_schedule(chosen.config.competition, opened.matches); !checked) {
    return print_error(kBadData,
                       "{}: {}; --force renames the old folder and starts "
                       "again",
                       (folder / kStoreFile).string(), checked.error().message);
  }

  warn_of_twins(chosen.config, arguments.session);
  RunOptions options;
  options.folder = folder;
  options.config = chosen.config;
  TournamentProgress progress(stderr_is_terminal(), arguments.session.quiet);
  progress.resume(chosen.config, opened.matches);
  const auto make =
      [&](const TournamentConfig& config) -> base::Result<std::unique_ptr<MatchExecutor>> {
    return arguments.results.empty() ? executors_in(folder)(config)
                                     : results_executor(config, arguments.results);
  };

  const auto summary = run_tournament(options, make, progress, watch_interrupts());
  progress.clear();
  if (!summary) {
    const bool listed = !arguments.results.empty();  // the file is wrong or incomplete
    return print_error(listed ? kBadData : kWriteFailed, summary.error().message);
  }

  const Report report = make_report(chosen.config, summary->matches, folder);
  const bool any = std::ranges::any_of(
      summary->matches, [](const ScheduledMatch& match) { return match.outcome.has_value(); });
  if (arguments.session.json) {
    fmt::print("{}", report_json(report));
  } else if (any && arguments.report) {
    fmt::print("{}{}", report_text(report, {stdout_width(), false, true}),
               watch_line(folder, summary->matches));
  }

  const bool listed = !arguments.session.json;  // the report lists them
  return end_session(*summary, chosen.config, arguments.session, exit_code_of(*summary), listed);
}

}  // namespace

int play_tournament(const std::string& folder, bool quiet) {
  TournamentRunArguments arguments;
  arguments.tournament.folder = folder;
  arguments.session.quiet = quiet;
  arguments.report = false;
  return run_tournament_command(arguments);
}

void add_tournament_run_command(Command& app) {
  auto [command, arguments] = app.command("run", kTournamentRunDescription, run_tournament_command);
  add_tournament_options(command, arguments.tournament);
  add_session_options(command, arguments.session, "report");
  command
      .option("--results", arguments.results,
              "play nothing: FILE has the results, as docs/tournaments.md describes")
      .placeholder("FILE");
}

}  // namespace cls::cli
