// The result of a match as plain data, and as the JSON document `cls.match/1` (result.json).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/system/version.h"
#include "match/result/speed.h"
#include "soccer/end_reason.h"
#include "soccer/side.h"

namespace cls::match {

using soccer::EndReason;

/// Latency of a player's decisions in microseconds, from request to reply.
struct RpcLatency {
  double p50 = 0.0;
  double p95 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

/// A call that a Playmaker answered with an error.
struct FailedCall {
  std::string rpc;
  std::string status;  ///< of gRPC: "UNKNOWN"; "unreadable reply"
  std::string message;
  int cycle = 0;
  int unum = 0;           ///< 12: coach
  std::string recording;  ///< file inside the match folder, for `cls test --replay`
};

/// All of those of a side.
struct ErrorResult {
  std::int64_t count = 0;
  std::optional<FailedCall> first;
};

/// By outcome ("executed", "failed", "skipped", "invalid", "unimplemented"), without zeros.
using ActionOutcomes = std::map<std::string, std::map<std::string, std::int64_t>>;

struct PlayerResult {
  int unum = 0;
  std::int64_t decisions = 0;  ///< requested from the Playmaker
  std::int64_t late = 0;       ///< no reply before the deadline
  std::int64_t missed = 0;     ///< no usable reply for any reason, late ones included
  std::map<std::string, std::int64_t> missed_by;  ///< reason ("deadline", "error"), without zeros
  std::int64_t reconnects = 0;     ///< replies after the connection to the Playmaker was lost
  std::int64_t undecided = 0;      ///< server cycles without a decision of this cls agent
  std::int64_t lost_commands = 0;  ///< too late for the server, or lost on the way
  std::int64_t late_wakeups = 0;   ///< real time: decisions that cls, not the Playmaker, began late
  RpcLatency rpc_us;
  std::map<std::string, std::int64_t> commands;               ///< by kind, as sent to the server
  std::map<std::string, std::int64_t> unimplemented_actions;  ///< by kind, as requested
  ActionOutcomes actions;                                     ///< by kind, as requested
  std::map<std::string, std::int64_t> automatic;  ///< the proxy's own decisions, by reason
  std::int64_t lists = 0;    ///< replies whose actions were tried: all but the automatic ones
  std::int64_t empty = 0;    ///< of these, without any action
  std::int64_t useless = 0;  ///< of these, without an executed action; includes empty ones
};

/// One Playmaker of a mixed side.
struct PartResult {
  std::string agents;  ///< as the user wrote them: "2-5,coach"
  std::string endpoint;
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  RpcLatency rpc_us;         ///< of all its agents' decisions
  double cpu_seconds = 0.0;  ///< of a Playmaker that cls started
};

struct TeamResult {
  std::string name;
  std::string endpoint;
  int score = 0;
  std::optional<int> penalty_score;  ///< only after a shoot-out
  double cpu_seconds = 0.0;          ///< of this side's agents
  std::vector<PlayerResult> players;
  std::optional<PlayerResult> coach;  ///< of a cls team; unum 12
  ErrorResult errors;
  std::vector<PartResult> parts;  ///< of a mixed side
};

/// How the Playmaker of a side replied: sums over its players.
struct ReplySummary {
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  std::int64_t lists = 0;
  std::int64_t empty = 0;
  std::int64_t useless = 0;
  RpcLatency rpc_us;  ///< p50 of the median player, the other figures of the slowest one
};

struct Goal {
  int cycle = 0;
  soccer::Side side = soccer::Side::kNeutral;  ///< the scoring side
  int unum = 0;                                ///< last kicker of that side; 0: unknown
};

/// A process started for the match.
struct ProcessResult {
  std::string name;     ///< "right Playmaker", "soccer server", "left player 7"
  std::string command;  ///< equivalent shell command line
  std::string log;      ///< file name inside the match folder
  std::string exit;     ///< "exit code 0", "killed by SIGTERM"
  double cpu_seconds = 0.0;
  double delayed_seconds = 0.0;  ///< ready to run, without a processor; not in the document
  std::string exception;         ///< first one in its output: "ValueError: no ball"; empty: none
  std::string log_error;  ///< why its log is incomplete; empty: it is not; not in the document
};

/// The program that made the match invalid, with its last output lines. One that cls did not start
/// has neither exit nor log nor output.
struct ProcessFailure {
  std::string process;
  std::string exit = {};
  std::string log = {};
  std::vector<std::string> output = {};  ///< last output lines, oldest first
  std::string rpc = {};                  ///< that was not answered; empty: no call was awaited
  int unum = 0;                          ///< whose call that was; 12: coach, 13: trainer; 0: none
  std::optional<int> cycle = {};         ///< of that call; none before the first cycle
};

/// A situation of a book that was played: figures of the left team minus those of the right one
/// (analysis/situations/situation_value.h).
struct SituationResult {
  std::string kind;  ///< "attack"
  std::string log;   ///< the recorded match
  int time = 0;      ///< of the moment in it
  int cycles = 0;    ///< played
  double value = 0.0;
  std::map<std::string, double> figures;  ///< by name: "goals", "expected_goals", ...
};

/// A match of situations.
struct BookResult {
  double value = 0.0;  ///< mean of the situations: the lead of the left team in goals a match
  std::vector<SituationResult> situations;
};

struct MatchResult {
  TeamResult left;
  TeamResult right;
  std::optional<PlayerResult> trainer;  ///< run by cls; unum 13
  EndReason end_reason = EndReason::kFinished;
  std::string message;                ///< one line on what went wrong; empty when finished
  std::optional<soccer::Side> fault;  ///< side of the Playmaker that made it invalid, if known
  std::optional<ProcessFailure> failure;
  bool try_again = false;   ///< nothing was started: a required port is in use; not in the document
  int signal = 0;           ///< that interrupted the match, else 0; not in the document
  std::string write_error;  ///< first file that could not be written; not in the document
  int cycles = 0;           ///< last game time
  std::int64_t steps = 0;
  std::uint64_t seed = 0;
  std::string mode = "lockstep";
  bool deterministic = true;
  std::string server_kind = "embedded";
  std::string server_version;
  std::optional<std::uint64_t> server_seed;  ///< of an external server; none: `seed`
  std::int64_t server_missed_cycles = 0;     ///< cycles of an external server without a reply
  std::optional<double> server_cpu_seconds;  ///< of a server process started by cls
  double wall_seconds = 0.0;                 ///< of the whole match, start included
  double cycles_per_second = 0.0;            ///< cycles over the time from first step to last
  std::optional<SpeedResult> speed;          ///< none: no cycle was played
  std::vector<Goal> goals;
  std::optional<BookResult> book;  ///< of a match with a book
  std::vector<std::string> warnings;
  std::vector<ProcessResult> processes;
  std::string rcg;  ///< file name inside the match folder; empty: not written
  std::string rcl;
  std::string folder;
  std::string cls_version{base::kVersion};
  std::string wire_version{base::kWireVersion};

  bool valid() const { return end_reason == EndReason::kFinished; }
  TeamResult& team(soccer::Side side) { return side == soccer::Side::kRight ? right : left; }
};

/// The player statistics of `cls.match/1`: a list, not indented.
std::string to_json(const std::vector<PlayerResult>& players);

/// `errors` of a side in `cls.match/1`, not indented.
std::string to_json(const ErrorResult& errors);

ReplySummary reply_summary(const TeamResult& team);

/// "left", "right" or "draw"; nothing for an invalid match.
std::optional<std::string> winner(const MatchResult& result);

/// The document `cls.match/1`, indented, with a newline at its end.
std::string to_json(const MatchResult& result);

/// Parses a document `cls.match/1`. Only its schema and its end reason are required: members that
/// earlier versions did not write keep their defaults.
base::Result<MatchResult> parse_match_result(std::string_view text);

}  // namespace cls::match
