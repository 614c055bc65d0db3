// The configuration of a tournament as plain data: teams, schedule, conditions, execution.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "match/terms/option_texts.h"
#include "tournament/config/stage.h"

namespace cls::match {
struct MatchOptions;
}

namespace cls::tournament {

enum class Format {
  kRoundRobin,         ///< every team against every other
  kGauntlet,           ///< some teams (`gauntlet`) against all others
  kList,               ///< the pairings of `matches`
  kGroups,             ///< round robin in groups, then a knockout of the best
  kKnockout,           ///< single elimination
  kDoubleElimination,  ///< elimination by the second loss
  kSwiss,              ///< pairs teams with similar points, never the same pair twice
  kStages,             ///< the `stages`, one after the other
};

/// The policy for invalid matches.
enum class OnCrash {
  kStop,     ///< the tournament stops; the next run plays the match again
  kForfeit,  ///< the side at fault loses 0:3; if none is known, the match stays invalid
  kRerun,    ///< the same match again, at most `max_reruns` times, then it stays invalid
};

enum class KeepLogs { kAll, kFailed, kNone };

/// Where matches run.
enum class ExecutorKind {
  kLocal,  ///< on this host
  kSlurm,  ///< on a Slurm cluster that shares the tournament's folder
  kHosts,  ///< on `hosts` that share nothing with this one
};

/// Criteria that order teams with the same points, see standings.h.
enum class TieBreaker {
  kHeadToHead,
  kGoalDifference,
  kGoalDifferenceAmong,  ///< among the tied teams only
  kGoals,
  kGoalsAmong,
  kWins,
  kBuchholz,
  kMedianBuchholz,
  kSonnebornBerger,
};

inline constexpr const char* kRemoteShell =
    "ssh -o BatchMode=yes -o ConnectTimeout=15 -o ServerAliveInterval=15 {host}";
inline constexpr const char* kRemoteFolder = ".cache/cls";

/// Columns of the standings table that users may choose (`columns`).
inline constexpr std::array<std::string_view, 22> kStandingsColumns = {
    "rank",       "team",    "played",    "won",      "drawn",           "lost",
    "goals",      "diff",    "points",    "score",    "interval",        "shoot-outs",
    "forfeits",   "invalid", "byes",      "buchholz", "median-buchholz", "sonneborn-berger",
    "tiebreaker", "elo",     "elo-error", "average"};

struct TeamEntry {
  std::string name;
  std::string endpoint;  ///< any SIDE except a name

  bool operator==(const TeamEntry&) const = default;
};

/// A parameter of the soccer server: {"server::half_time", "300"}.
struct ServerSetting {
  std::string name;
  std::string value;

  bool operator==(const ServerSetting&) const = default;
};

/// A tournament. All but the last two blocks are the plan: runs with the same plan play the same
/// matches under the same conditions.
struct TournamentConfig {
  // The schedule.
  Format format = Format::kRoundRobin;
  std::optional<int> rounds;  ///< see rounds_of()
  std::uint64_t seed = 1;     ///< all seeds and draws follow from it
  bool swap_sides = true;     ///< every pairing is two matches on one seed, once from each side
  bool draw = false;          ///< random seeding order instead of the order of `teams`
  std::vector<std::string> gauntlet;
  std::vector<std::vector<std::string>> matches;  ///< kList: two team names each
  int groups = 2;
  int advance = 2;  ///< teams of each group that advance to the knockout
  bool third_place = true;
  std::vector<TieBreaker> tie_breakers;  ///< empty: those of the format
  std::vector<Stage> stages;             ///< kStages
  std::vector<TeamEntry> teams;          ///< in the order of the file

  // Every match. The use of an option says whether it belongs to the plan.
  match::OptionTexts options;  ///< of match::match_options(); those not set have no text
  std::vector<ServerSetting> settings;

  // Execution; may change from run to run.
  int concurrency = 0;  ///< parallel matches; 0: automatic
  bool pin = false;     ///< pin each running match to its own cores
  ExecutorKind executor = ExecutorKind::kLocal;
  std::vector<std::string> slurm_options;  ///< arguments for sbatch, such as "--partition=short"
  int slurm_tasks = 1000;                  ///< maximum of pending and running matches in Slurm
  std::optional<double> slurm_poll_s;      ///< interval of squeue polls; default 10
  std::vector<std::string> hosts;          ///< kHosts: "node1", or "4/node1" for 4 parallel matches
  std::string remote_shell;   ///< kHosts: runs a command line on {host}; empty: kRemoteShell
  std::string remote_folder;  ///< kHosts: for teams and matches there; empty: kRemoteFolder
  OnCrash on_crash = OnCrash::kStop;
  int max_reruns = 2;
  KeepLogs keep_logs = KeepLogs::kAll;
  std::string on_event;                ///< shell command at start, goal, ... of each match
  std::string on_match_finish;         ///< shell command that gets the match as JSON on stdin
  std::string on_finish;               ///< shell command that gets the report as JSON on stdin
  std::optional<double> hook_limit_s;  ///< for these commands; none: process::kHookLimit
  std::filesystem::path folder;        ///< of the file; base of relative paths in endpoints

  // Reports.
  std::string name;                      ///< of the tournament; empty: that of its folder
  std::vector<std::string> columns;      ///< of kStandingsColumns; empty: as the format needs
  std::vector<std::string> start_times;  ///< see config/start_times.h
  std::optional<double> slot_minutes;    ///< from one match to the next on a server
};

/// The options of every match: those of `cls match` where the configuration says nothing. Wrong
/// texts and settings count as not set; validate() reports them.
match::MatchOptions match_options(const TournamentConfig& config);

/// The configured rounds, or the default: 1; Swiss: ceil(log2(teams)) + 1, limited so that no teams
/// meet twice.
int rounds_of(const TournamentConfig& config);

/// Index of the team `name`, or -1.
int team_index(const TournamentConfig& config, std::string_view name);

/// The names in the configuration file, such as "round-robin", "forfeit", "goal-difference".
std::string_view name(Format format);
std::string_view name(OnCrash on_crash);
std::string_view name(KeepLogs keep);
std::string_view name(ExecutorKind executor);
std::string_view name(TieBreaker breaker);

/// All contradictions and invalid values, one line each, without the file name. Endpoints and
/// settings are checked as in `cls match`.
std::vector<std::string> validate(const TournamentConfig& config);

}  // namespace cls::tournament
