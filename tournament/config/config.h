// The configuration of a tournament as plain data.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/enum_names.h"
#include "league/competition/competition.h"
#include "match/terms/option_texts.h"

namespace cls::match {
struct MatchOptions;
}

namespace cls::tournament {

// The words of a league, such as Competition, Fixture and Outcome, are those of a tournament, too.
using namespace league;

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

// The names in the configuration file.
inline constexpr auto kOnCrashNames = base::enum_names<OnCrash>("stop", "forfeit", "rerun");
inline constexpr auto kKeepLogsNames = base::enum_names<KeepLogs>("all", "failed", "none");
inline constexpr auto kExecutorNames = base::enum_names<ExecutorKind>("local", "slurm", "hosts");

inline constexpr const char* kRemoteShell =
    "ssh -o BatchMode=yes -o ConnectTimeout=15 -o ServerAliveInterval=15 {host}";
inline constexpr const char* kRemoteFolder = ".cache/cls";

/// Columns of the standings table that users may choose (`columns`).
inline constexpr std::array<std::string_view, 22> kStandingsColumns = {
    "rank",       "team",    "played",    "won",      "drawn",           "lost",
    "goals",      "diff",    "points",    "score",    "interval",        "shoot-outs",
    "forfeits",   "invalid", "byes",      "buchholz", "median-buchholz", "sonneborn-berger",
    "tiebreaker", "elo",     "elo-error", "average"};

/// A parameter of the soccer server: {"server::half_time", "300"}.
struct ServerSetting {
  std::string name;
  std::string value;

  bool operator==(const ServerSetting&) const = default;
};

/// How a match is played.
struct Conditions {
  match::OptionTexts options;  ///< of match::match_options(); those not set have no text
  std::vector<ServerSetting> settings;

  /// True for "server::half_time" if the tournament sets it.
  bool sets(std::string_view parameter) const {
    return std::ranges::find(settings, parameter, &ServerSetting::name) != settings.end();
  }
};

/// Where and how the schedule is executed.
struct Execution {
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
};

/// How the tournament is presented.
struct Presentation {
  std::string name;                      ///< of the tournament; empty: that of its folder
  std::vector<std::string> columns;      ///< of kStandingsColumns; empty: as the format needs
  std::vector<std::string> start_times;  ///< see config/start_times.h
  std::optional<double> slot_minutes;    ///< from one match to the next on a server
};

/// A tournament. Competition and conditions are the plan: runs with the same plan play the same
/// matches under the same conditions. The use of an option says whether it belongs to the plan. The
/// rest may change from run to run.
struct TournamentConfig {
  Competition competition;
  Conditions conditions;
  Execution execution;
  Presentation report;
};

/// The options of every match: those of `cls match` where the configuration says nothing. Wrong
/// texts and settings count as not set; validate() reports them.
match::MatchOptions match_options(const Conditions& conditions);

/// All contradictions and invalid values, one line each, without the file name. Endpoints and
/// settings are checked as in `cls match`.
std::vector<std::string> validate(const TournamentConfig& config);

/// What equal sides play twice, in one line: intervals count it twice, and a split of a data set
/// into training and test leaks. Empty: no two teams have the same endpoint, or each pair is played
/// once.
std::string twin_sides(const TournamentConfig& config);

}  // namespace cls::tournament
