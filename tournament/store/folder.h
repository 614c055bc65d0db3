// The folder of a tournament: file names, its lock, its plan and its state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/system/unique_fd.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// Names inside a tournament's folder.
inline constexpr const char* kPlanFile = "plan.toml";           ///< the resolved configuration
inline constexpr const char* kStoreFile = "tournament.db";      ///< see store.h
inline constexpr const char* kScheduleFile = "schedule.jsonl";  ///< a line a match, for `work`
inline constexpr const char* kTournamentEvents = "events.jsonl";
inline constexpr const char* kMatchEvents = "match-events.jsonl";  ///< cls.event/1, for on_event
inline constexpr const char* kMatchesFolder = "matches";
inline constexpr const char* kResultsFolder = "results";        ///< result files of `work`
inline constexpr const char* kUnfinishedFolder = "unfinished";  ///< what `work` has in hand
inline constexpr const char* kSlurmFolder = "slurm";            ///< job arrays, see slurm_batch.h
inline constexpr const char* kHostsFolder = "hosts";            ///< see hosts_executor.cpp
inline constexpr const char* kStopFile = "stop";
inline constexpr const char* kLockFile = "lock";

/// "matches/000017-RED-vs-BLUE"; attempts after the first end in ".2", ".3", ...
std::filesystem::path match_folder(const TournamentConfig& config, const Fixture& fixture,
                                   int attempt);

/// "results/000017.1.json".
std::filesystem::path result_file(int index, int attempt);

/// The number of a match in the name of its folder: 17 of "000017-RED-vs-BLUE" or "000017.1.LABEL";
/// nothing for other names.
std::optional<int> match_number(const std::filesystem::path& folder);

/// Creates a folder below matches/ that match_folder() names. False if it exists: it belongs to the
/// process that created it, which may be playing in it.
bool claim_folder(const std::filesystem::path& folder);

/// True if `file` exists below `folder`, also when links are followed: a tournament or data set of
/// a stranger may name any other file, and hold links to any other one.
bool is_inside(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The host in unfinished_label(): the name of this one as part of a file name.
std::string unfinished_host();

/// HOST-PID: distinct from that of every other process that plays the same match.
std::string unfinished_label();

/// "unfinished/000017.1.LABEL": match folder of one process, which `label` identifies; with an
/// extension of the label, the result that it is writing.
std::filesystem::path unfinished_folder(int index, int attempt, std::string_view label);

/// The begin of names in results/ and unfinished/.
struct AttemptName {
  int index = 0;
  int attempt = 0;
  std::string_view rest;  ///< after the second dot
};

/// {17, 2, "json"} for "000017.2.json".
std::optional<AttemptName> parse_attempt_name(std::string_view name);

/// The text of a file that a tournament need not have; then empty. An error if it cannot be read.
base::Result<std::string> read_if_there(const std::filesystem::path& file);

/// Held by the one `cls tournament run` that may write to a folder. Released when the process
/// exits.
class FolderLock {
 public:
  /// Nothing when another process holds the lock of `folder`. Waits a tenth of a second for it:
  /// is_held() takes a share of the lock for a moment.
  static base::Result<std::optional<FolderLock>> try_lock(const std::filesystem::path& folder);
  /// True when a process holds the lock. For readers: needs no right to write.
  static bool is_held(const std::filesystem::path& folder);

 private:
  explicit FolderLock(base::UniqueFd file) : file_(std::move(file)) {}
  base::UniqueFd file_;
};

/// An error when a tournament with another plan has begun in `folder`; it names the first
/// difference.
base::Result<void> check_plan(const std::filesystem::path& folder, const TournamentConfig& config);

/// Creates `folder` and writes the plan of the valid `config`, which passed check_plan().
base::Result<void> write_plan(const std::filesystem::path& folder, const TournamentConfig& config);

/// Does both: check_plan() and write_plan().
base::Result<void> prepare_folder(const std::filesystem::path& folder,
                                  const TournamentConfig& config);

/// The configuration that prepare_folder wrote.
base::Result<TournamentConfig> read_plan(const std::filesystem::path& folder);

/// True when the folder holds a plan.
bool holds_plan(const std::filesystem::path& folder);

/// Writes schedule.jsonl; read_fixture reads one match of such a file.
base::Result<void> write_schedule(const std::filesystem::path& folder,
                                  const std::vector<ScheduledMatch>& matches);
base::Result<Fixture> read_fixture(const std::filesystem::path& schedule, int index);

/// Configuration and matches of a tournament.
struct TournamentState {
  TournamentConfig config;
  std::vector<ScheduledMatch> matches;  ///< by number
  std::size_t stored = 0;               ///< of these, in the store; the others were not played
  std::vector<int> running;             ///< numbers, ascending; empty without a running `run`
  bool paused = false;                  ///< a technical time-out has not ended
};

/// Reads plan, store and result files of `work`, without writing. An error if they contradict each
/// other, or if the store was lost (lost_store.h), which a `run` mends: no matches
/// then, with `may_be_lost`.
base::Result<TournamentState> read_tournament(const std::filesystem::path& folder,
                                              bool may_be_lost = false);

}  // namespace cls::tournament
