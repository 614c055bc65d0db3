// What `cls tournament run` and `cls compare` share: opening the folder, and the end of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/store/folder.h"

namespace CLI {
class App;
}

namespace cls::cli {

struct SessionOptions {
  bool force = false;
  bool no_preflight = false;
  bool strict = false;
  bool json = false;
  bool quiet = false;
};

/// Adds --force, --no-preflight, --strict, --json and --quiet; `options` must outlive `command`.
/// `document` is what --json prints: "the report".
void add_session_options(CLI::App& command, SessionOptions& options, const std::string& document);

/// The folder of a run, locked while this exists; or an exit code whose error is already printed.
struct OpenedFolder {
  int exit_code = 0;
  std::optional<orchestration::tournament::FolderLock> lock;
  std::vector<orchestration::tournament::ScheduledMatch> matches;  ///< scheduled so far
};

/// Creates or continues the tournament of the valid `config` in `folder`. `force` first renames an
/// old tournament there, but leaves its cls.toml in place.
OpenedFolder open_folder(const std::filesystem::path& folder,
                         const orchestration::tournament::TournamentConfig& config, bool force);

/// Checks teams and host before the first of about `to_play` matches; does nothing for 0. Prints
/// errors, warnings, and `outlook` with the expected time. Returns kOk or the exit code of the
/// first error.
int run_preflight(const orchestration::tournament::TournamentConfig& config,
                  const std::filesystem::path& folder, const OpenedFolder& opened,
                  const SessionOptions& options, double to_play, const std::string& outlook);

/// Prints the warnings of the matches, unless `listed` already, their number and, after an
/// incomplete run, the command that resumes it. Returns `exit_code`; with --strict kFailed if there
/// are warnings and it was kOk or kUndecided.
int end_session(const orchestration::tournament::RunSummary& summary,
                const orchestration::tournament::TournamentConfig& config,
                const SessionOptions& options, int exit_code, bool listed);

}  // namespace cls::cli
