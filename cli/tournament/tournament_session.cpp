// Opens folders, prints warnings and resume commands.
#include "cli/tournament/tournament_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/system/own_program.h"
#include "base/text/counted.h"
#include "cli/support/command_line.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "match/result/match_folder.h"
#include "process/command_plan.h"
#include "tournament/config/config_file.h"
#include "tournament/report/report_model.h"
#include "tournament/run/preflight.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

int busy(const fs::path& folder) {
  return print_error(kTryAgain, "{}: another `cls tournament run` or `cls compare` is in progress",
                     folder.string());
}

int start_over(const fs::path& folder) {
  TRY_INIT_OR(kCannotCreate, const auto aside, base::set_aside(folder));
  fmt::print(stderr, "cls: old tournament moved to {}\n", aside.string());

  std::error_code code;
  fs::create_directories(folder, code);
  if (fs::exists(aside / kConfigFile, code)) {
    fs::copy_file(aside / kConfigFile, folder / kConfigFile, code);
  }
  return kOk;
}

int exit_code_of(match::EndpointProblem::Kind kind) {
  using Kind = match::EndpointProblem::Kind;
  switch (kind) {
    case Kind::kUnreachable:
      return kUnavailable;
    case Kind::kMissing:
      return kNoInput;
    case Kind::kBadScript:
      return kBadData;
    case Kind::kUnknown:
      return kBadConfig;
  }
  return kInternalError;
}

// A warning and the matches that gave it.
struct Warning {
  std::string text;
  std::vector<const ScheduledMatch*> matches;
};

std::vector<Warning> warnings_of(const std::vector<ScheduledMatch>& matches) {
  std::vector<Warning> warnings;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome) continue;
    for (const std::string& text : match.outcome->warnings) {
      auto known = std::ranges::find(warnings, text, &Warning::text);
      if (known == warnings.end()) known = warnings.insert(known, {text, {}});
      known->matches.push_back(&match);
    }
  }

  return warnings;
}

std::string warning_line(const TournamentConfig& config, const Warning& warning) {
  const Fixture& first = warning.matches.front()->fixture;
  std::string where =
      fmt::format("match {} ({} - {})", first.index, config.competition.team(first.left),
                  config.competition.team(first.right));
  if (const std::size_t more = warning.matches.size() - 1; more > 0) {
    where += fmt::format(" and {} more", more);
  }
  return fmt::format("{}: {}", where, warning.text);
}

void print_warnings(const TournamentConfig& config, const std::vector<Warning>& warnings) {
  constexpr std::size_t kShown = 10;
  for (std::size_t i = 0; i < std::min(kShown, warnings.size()); ++i) {
    print_error(0, "warning: " + warning_line(config, warnings[i]));
  }
  if (warnings.size() <= kShown) return;
  print_error(0, "{} more kinds of warnings: `warnings` in the JSON report",
              warnings.size() - kShown);
}

std::string warning_counts(const std::vector<ScheduledMatch>& matches) {
  std::size_t warnings = 0;
  int warned = 0;
  for (const ScheduledMatch& match : matches) {
    const std::size_t count = match.outcome ? match.outcome->warnings.size() : 0;
    warnings += count;
    warned += count > 0;
  }
  return base::counted(warnings, "warning") + " in " + base::counted(warned, "match", "matches");
}

// Prints and returns the error if another process works in the folder.
int check_idle(const fs::path& folder) {
  if (!holds_plan(folder)) return kOk;
  const auto lock = FolderLock::try_lock(folder);
  return lock && !*lock ? busy(folder) : kOk;
}

OpenedFolder open_folder(const fs::path& folder, const TournamentConfig& config, bool afresh) {
  const auto failed = [](int exit_code) { return OpenedFolder{exit_code, {}, {}}; };
  if (afresh) {
    // A relative path may lead through the folder that is renamed.
    if (const int code = start_over(fs::absolute(folder)); code != kOk) return failed(code);
  }

  if (const auto created = base::create_folders(folder); !created) {
    return failed(print_error(kCannotCreate, created.error().message));
  }
  auto lock = FolderLock::try_lock(folder);
  if (!lock) return failed(print_error(kCannotCreate, lock.error().message));
  if (!*lock) return failed(busy(folder));

  if (const auto same = check_plan(folder, config); !same) {
    return failed(print_error(kBadConfig, same.error().message));
  }
  if (const auto written = write_plan(folder, config); !written) {
    return failed(print_error(kCannotCreate, written.error().message));
  }

  auto state = read_tournament(folder, true);
  if (!state) return failed(print_error(kBadData, state.error().message));
  state->matches.resize(state->stored);
  return {kOk, *std::move(lock), std::move(state->matches)};
}

// The plan with the teams that still play.
TournamentConfig without_withdrawn(TournamentConfig config,
                                   const std::vector<ScheduledMatch>& matches) {
  std::vector<std::string> gone;
  for (const int team : withdrawn_teams(matches)) gone.push_back(config.competition.team(team));
  std::erase_if(config.competition.teams,
                [&gone](const TeamEntry& team) { return std::ranges::count(gone, team.name) > 0; });
  return config;
}

// Checks teams and host before the first match; prints errors, warnings and the outlook.
int run_preflight(const fs::path& folder, const TournamentConfig& config,
                  const SessionOptions& options, const std::vector<ScheduledMatch>& matches,
                  const Outlook& outlook) {
  constexpr double kPatienceS = 5.0;
  if (outlook.to_play <= 0) return kOk;

  if (!options.no_preflight) {
    const std::chrono::duration<double> patience(
        std::min(kPatienceS, match_options(config.conditions).start_timeout_s));
    const auto problems =
        check_start(without_withdrawn(config, matches),
                    std::chrono::duration_cast<std::chrono::milliseconds>(patience));
    for (const StartProblem& problem : problems) print_error(0, problem.text);
    if (!problems.empty()) {
      return print_error(exit_code_of(problems.front().kind),
                         options.has_no_preflight
                             ? "no match was started; --no-preflight starts without this check"
                             : "no match was started");
    }

    const auto warnings = host_warnings(config, matches, outlook.to_play, folder);
    const bool fails = options.strict && !warnings.empty();
    for (const std::string& line : warnings) {
      if (fails || !options.quiet) print_error(0, "warning: " + line);
    }
    if (fails) return print_error(kFailed, "no match was started (--strict)");
  }

  if (options.quiet) return kOk;
  const auto seconds = expected_seconds(config, matches, outlook.to_play);
  fmt::print(stderr, "cls: {}{}\n", outlook.text,
             seconds ? ", about " + duration_text(*seconds) : "");
  return kOk;
}

}  // namespace

int check_tournament(const fs::path& folder, std::string_view remedy) {
  if (holds_plan(folder)) return kOk;
  return print_error(kNoInput, "{}: no tournament{}", folder.string(), remedy);
}

void add_session_options(Command& command, SessionOptions& options, const std::string& document) {
  command.flag("--force", options.force, "start over; an old tournament is renamed to .old");
  options.has_no_preflight = true;
  command.flag("--no-preflight", options.no_preflight,
               "start without checking teams and host first");
  command.flag("--strict", options.strict, "fail (exit 1) on any warning").of_group(kOutputGroup);
  command.flag("--json", options.json, fmt::format("print only the {} as JSON", document))
      .of_group(kOutputGroup);
  command.flag("--quiet", options.quiet, "print no progress and no notes").of_group(kOutputGroup);
}

OpenedFolder begin_session(const fs::path& folder, const TournamentConfig& config,
                           const SessionOptions& options, const OutlookOf& outlook_of) {
  if (const int code = check_idle(folder); code != kOk) return {code, {}, {}};

  // What cannot start renames nothing.
  const bool afresh = options.force && holds_plan(folder);
  if (afresh) {
    const int code = run_preflight(folder, config, options, {}, outlook_of({}));
    if (code != kOk) return {code, {}, {}};
  }

  OpenedFolder opened = open_folder(folder, config, afresh);
  if (opened.exit_code == kOk && !afresh) {
    opened.exit_code =
        run_preflight(folder, config, options, opened.matches, outlook_of(opened.matches));
  }
  return opened;
}

void warn_of_twins(const TournamentConfig& config, const SessionOptions& options) {
  const std::string twins = twin_sides(config);
  if (!twins.empty() && !options.quiet) print_error(0, "warning: " + twins);
}

MakeExecutor executors_in(const fs::path& folder) {
  return [folder](const TournamentConfig& config) -> base::Result<std::unique_ptr<MatchExecutor>> {
    TRY_INIT(const auto program, base::own_program());
    return make_executor(config, folder, program);
  };
}

std::string watch_line(const fs::path& folder, std::span<const ScheduledMatch> matches) {
  std::string line;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || match.outcome->folder.empty()) continue;
    const fs::path played = folder / match.outcome->folder;
    // A match that was refused has a folder without a log.
    std::error_code code;
    if (!fs::exists(match::game_log_in(played), code)) continue;
    line =
        fmt::format("  cls watch {}\n", process::shell_quoted(played.lexically_normal().string()));
  }
  return line;
}

int end_session(const RunSummary& summary, const TournamentConfig& config,
                const SessionOptions& options, int exit_code, bool listed) {
  const std::vector<Warning> warnings = warnings_of(summary.matches);
  if (!options.quiet && !listed) print_warnings(config, warnings);
  if (!summary.message.empty()) print_error(0, summary.message);
  if (summary.end != RunEnd::kComplete && summary.end != RunEnd::kDecided) {
    print_error(0, "{} ({})", counts_text(count(summary.matches)), name(summary.end));
    fmt::print(stderr, "cls: resume: {}\n", resume_command());  // one line, to be copied
  }

  if (!summary.write_error.empty()) {
    print_error(0, summary.write_error);
    if (exit_code == kOk) exit_code = kWriteFailed;
  }

  if (warnings.empty()) return exit_code;
  const std::string counts = warning_counts(summary.matches);
  const bool fails = options.strict && (exit_code == kOk || exit_code == kUndecided);
  if (fails) return print_error(kFailed, "{} (--strict)", counts);
  if (!options.quiet) print_error(0, counts);
  return exit_code;
}

}  // namespace cls::cli
