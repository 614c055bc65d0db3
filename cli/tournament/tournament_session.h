// Common steps of `cls tournament run` and `cls compare`: opening the folder, and the end of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command/command.h"
#include "tournament/config/config.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/folder.h"

namespace cls::cli {

/// Prints an error, with `remedy` at its end, if `folder` holds no tournament. Returns an exit
/// code.
int check_tournament(const std::filesystem::path& folder, std::string_view remedy = "");

/// The hint of a command where a tournament could be begun.
inline constexpr std::string_view kRunCreatesOne = "; `cls tournament run` creates one";

struct SessionOptions {
  bool force = false;
  bool no_preflight = false;
  bool has_no_preflight = false;  ///< the command has the option --no-preflight
  bool strict = false;
  bool json = false;
  bool quiet = false;
};

/// Adds --force, --no-preflight, --strict, --json and --quiet; `options` must outlive `command`.
/// `document` is what --json prints: "the report".
void add_session_options(Command& command, SessionOptions& options, const std::string& document);

/// The folder of a run, locked while this exists; or an exit code whose error is already printed.
struct OpenedFolder {
  int exit_code = 0;
  std::optional<tournament::FolderLock> lock;
  std::vector<tournament::ScheduledMatch> matches;  ///< scheduled so far
};

/// Makes executors of a tournament in `folder`, which start this program.
tournament::MakeExecutor executors_in(const std::filesystem::path& folder);

/// The matches that are left to play.
struct Outlook {
  double to_play = 0.0;  ///< expected number of matches
  std::string text;
};
using OutlookOf = std::function<Outlook(const std::vector<tournament::ScheduledMatch>&)>;

/// Creates or continues the tournament of the valid `config` in `folder`. Checks teams and host
/// unless nothing is left to play, and prints warnings and the outlook for the matches scheduled so
/// far with the expected time. --force renames an old tournament, but leaves its cls.toml in place;
/// a failed check renames nothing.
OpenedFolder begin_session(const std::filesystem::path& folder,
                           const tournament::TournamentConfig& config,
                           const SessionOptions& options, const OutlookOf& outlook_of);

/// Warns of equal sides, whose matches are mirror images; see twin_sides().
void warn_of_twins(const tournament::TournamentConfig& config, const SessionOptions& options);

/// The line that shows the last match whose logs are kept, "  cls watch cup/matches/...\n"; empty
/// if there is none.
std::string watch_line(const std::filesystem::path& folder,
                       std::span<const tournament::ScheduledMatch> matches);

/// Prints the warnings of the matches, unless `listed` already, their number and, after an
/// incomplete run, the command that resumes it. Returns `exit_code`; with --strict kFailed if there
/// are warnings and it was kOk or kUndecided.
int end_session(const tournament::RunSummary& summary, const tournament::TournamentConfig& config,
                const SessionOptions& options, int exit_code, bool listed);

/// Plays or resumes the tournament of `folder`/cls.toml, as `cls tournament run` does, but prints
/// no report; `quiet`: errors only. Returns its exit code.
int play_tournament(const std::string& folder, bool quiet);

}  // namespace cls::cli
