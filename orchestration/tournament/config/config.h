// What a tournament is, as plain data: who plays, in which order, under which conditions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::orchestration::tournament {

enum class Format {
  kRoundRobin,         ///< everybody against everybody
  kGauntlet,           ///< some teams (`gauntlet`) against all others
  kList,               ///< the pairings of `matches`
  kGroups,             ///< round robin in groups, then knock-out of the best
  kKnockout,           ///< who loses is out
  kDoubleElimination,  ///< who loses twice is out
  kSwiss,              ///< in every round teams with about the same points, nobody twice
};

/// What becomes of a match that is invalid through a fault in play or at its start.
enum class OnCrash {
  kStop,     ///< the tournament ends; the next run plays the match again
  kForfeit,  ///< the side at fault loses 0:3; without a known culprit the match stays invalid
  kRerun,    ///< the same match again, `max_reruns` times at most, then it stays invalid
};

enum class KeepLogs { kAll, kFailed, kNone };

/// Where matches are played.
enum class ExecutorKind {
  kLocal,  ///< on this machine
  kSlurm,  ///< by a Slurm cluster that sees the tournament's folder
};

/// Criteria that separate teams with the same points, see standings.h.
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

struct TeamEntry {
  std::string name;
  std::string endpoint;  ///< any side form but a name

  bool operator==(const TeamEntry&) const = default;
};

/// A value of the soccer server: {"server::half_time", "300"}.
struct ServerSetting {
  std::string name;
  std::string value;

  bool operator==(const ServerSetting&) const = default;
};

/// A tournament. Everything but the last block makes the plan: two runs with the same plan play
/// the same matches under the same conditions.
struct TournamentConfig {
  // The schedule.
  Format format = Format::kRoundRobin;
  std::optional<int> rounds;  ///< see rounds_of()
  std::uint64_t seed = 1;     ///< all seeds and draws follow from it
  bool swap_sides = true;     ///< every pairing twice on one seed, once from each side
  bool draw = false;          ///< seeding order by lot instead of the order of `teams`
  std::vector<std::string> gauntlet;
  std::vector<std::vector<std::string>> matches;  ///< kList: two team names each
  int groups = 2;
  int advance = 2;  ///< teams of a group that go on to the knock-out
  bool third_place = true;
  std::vector<TieBreaker> tie_breakers;  ///< empty: those of the format
  std::vector<TeamEntry> teams;          ///< in the order of the file

  // The conditions of every match.
  std::optional<int> cycles;
  std::optional<int> half_time;
  std::string mode;    ///< empty: as `cls match` chooses
  std::string server;  ///< empty: as `cls match` chooses
  std::optional<int> rpc_deadline_ms;
  std::optional<int> max_missed;
  std::vector<ServerSetting> settings;

  // How it is carried out; may change from run to run.
  int concurrency = 0;  ///< matches at once; 0: automatic
  bool pin = false;     ///< each running match on processors of its own
  ExecutorKind executor = ExecutorKind::kLocal;
  std::vector<std::string> slurm_options;  ///< words for sbatch, such as "--partition=short"
  int slurm_tasks = 1000;                  ///< matches that wait or run in Slurm, at most
  std::optional<double> slurm_poll_s;      ///< between questions to squeue; else 10
  OnCrash on_crash = OnCrash::kStop;
  int max_reruns = 2;
  KeepLogs keep_logs = KeepLogs::kAll;
  std::optional<double> start_timeout_s;
  std::optional<double> stall_after_s;
  std::optional<double> time_limit_s;
  std::string on_match_finish;   ///< line of shell that gets the match as JSON on stdin
  std::string on_finish;         ///< line of shell that gets the report as JSON on stdin
  std::filesystem::path folder;  ///< of the file: relative paths in endpoints start there
};

/// Rounds as given, else 1; Swiss: ceil(log2(teams)) + 1, as far as nobody meets
/// twice.
int rounds_of(const TournamentConfig& config);

/// Place of `name` among the teams, or -1.
int team_index(const TournamentConfig& config, std::string_view name);

/// The words of the configuration file, such as "round-robin", "forfeit", "goal-difference".
std::string_view name(Format format);
std::string_view name(OnCrash on_crash);
std::string_view name(KeepLogs keep);
std::string_view name(ExecutorKind executor);
std::string_view name(TieBreaker breaker);

/// Everything in `config` that contradicts itself or cannot be played, one line each, without the
/// name of the file. Endpoints and settings are checked as `cls match` does.
std::vector<std::string> mistakes_in(const TournamentConfig& config);

}  // namespace cls::orchestration::tournament
