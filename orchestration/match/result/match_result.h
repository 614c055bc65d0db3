// The outcome of a match as plain data, and as the JSON document `cls.match/1`.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/match/result/end_reason.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// Latency of a player's decisions in microseconds, from the call to the answer.
struct RpcLatency {
  double p50 = 0.0;
  double p95 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

struct PlayerResult {
  int unum = 0;
  std::int64_t decisions = 0;  ///< asked for
  std::int64_t late = 0;       ///< without an answer at the deadline
  std::int64_t missed = 0;     ///< without a usable answer for any reason, late ones included
  std::map<std::string, std::int64_t> missed_by;  ///< reason ("deadline", "error"), without zeros
  std::int64_t reconnects = 0;     ///< times that a Playmaker that was lost answered again
  std::int64_t undecided = 0;      ///< cycles that the server passed without a decision of ours
  std::int64_t lost_commands = 0;  ///< came too late for the server, or not at all
  std::int64_t late_wakeups = 0;   ///< real time: decisions that we, not the Playmaker, began late
  RpcLatency rpc_us;
  std::map<std::string, std::int64_t> commands;               ///< by kind, as sent to the server
  std::map<std::string, std::int64_t> unimplemented_actions;  ///< by kind, as asked for
};

struct TeamResult {
  std::string name;
  std::string endpoint;
  int score = 0;
  std::optional<int> penalty_score;  ///< only after a shoot-out
  double cpu_seconds = 0.0;          ///< of this side's agents
  std::vector<PlayerResult> players;
  std::optional<PlayerResult> coach;  ///< of ours, with the number 12
};

struct Goal {
  int cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< that scored
  int unum = 0;                                ///< last kicker of that side; 0 unknown
};

/// A process that the match started.
struct ProcessResult {
  std::string name;     ///< "right Playmaker", "soccer server", "left player 7"
  std::string command;  ///< one line of shell that does the same
  std::string log;      ///< file name inside the match folder
  std::string exit;     ///< "exit code 0", "killed by SIGTERM"
  double cpu_seconds = 0.0;
};

/// The process that made the match invalid, and its last words.
struct ProcessFailure {
  std::string process;
  std::string exit;
  std::string log;
  std::vector<std::string> output;  ///< its last lines, oldest first
};

struct MatchResult {
  TeamResult left;
  TeamResult right;
  std::optional<PlayerResult> trainer;  ///< of ours, with the number 13
  EndReason end_reason = EndReason::kFinished;
  std::string message;  ///< one line on what went wrong; empty when finished
  std::optional<soccer::Side>
      fault;  ///< whose Playmaker made the match invalid, where that is known
  std::optional<ProcessFailure> failure;
  bool try_again = false;   ///< nothing was started: a port that must be used is taken
  int signal = 0;           ///< that interrupted the match, else 0
  std::string write_error;  ///< first file that could not be written to its end; empty: none
  int cycles = 0;           ///< last game time
  std::int64_t steps = 0;
  std::uint64_t seed = 0;
  std::string mode = "lockstep";
  bool deterministic = true;
  std::string server_kind = "embedded";
  std::string server_version;
  std::optional<std::uint64_t> server_seed;  ///< drawn by a foreign server; none: `seed`
  std::int64_t server_missed_cycles = 0;     ///< that a foreign server had to do without an answer
  std::optional<double> server_cpu_seconds;  ///< of a server process that we started
  double wall_seconds = 0.0;                 ///< of the whole match, start included
  double cycles_per_second = 0.0;            ///< cycles over the time from first step to last
  std::vector<Goal> goals;
  std::vector<std::string> warnings;
  std::vector<ProcessResult> processes;
  std::string rcg;  ///< file name inside the match folder, empty when none was written
  std::string rcl;
  std::string folder;

  bool valid() const { return end_reason == EndReason::kFinished; }
};

/// What players did, as in `cls.match/1`: a list, not indented.
std::string to_json(const std::vector<PlayerResult>& players);

/// "left", "right" or "draw"; nothing for an invalid match.
std::optional<std::string> winner(const MatchResult& result);

/// The document `cls.match/1`, indented, with a newline at its end.
std::string to_json(const MatchResult& result);

}  // namespace cls::orchestration::match
