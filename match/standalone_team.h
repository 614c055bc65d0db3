// A cls team on an external soccer server (`cls proxy`).
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "proxy/agent/debug_options.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/batch_playmaker.h"
#include "proxy/playmaker/grpc_target.h"
#include "soccer/end_reason.h"

namespace cls::match {

struct StandaloneTeamOptions {
  std::string server_host = "localhost";
  int server_port = 6000;
  int coach_port = 0;    ///< 0: no coach
  int trainer_port = 0;  ///< 0: no trainer
  proxy::GrpcTarget playmaker;
  bool thrift = false;            ///< the Playmaker speaks Thrift; without TLS and Unix sockets
  bool add_20_for_right = false;  ///< ports of the Playmaker of a team on the right are 20 higher
  /// One call per team and cycle. kAuto asks for one agent alone with single calls; a Playmaker
  /// with a port per agent always gets single calls.
  proxy::BatchMode batch = proxy::BatchMode::kAuto;
  proxy::TeamOptions team;
  proxy::DebugOptions debug;      ///< for soccerwindow2
  std::string offline_log;        ///< folder for proxy::OfflineLogs; empty: none
  double start_timeout_s = 20.0;  ///< limit for the server to accept the team
  /// Called once, when the players are on the pitch and registered; may be empty.
  std::function<void(const proxy::Team&)> on_ready;
};

/// The end of a team's match; the score as the team heard it.
struct StandaloneTeamResult {
  EndReason end_reason = EndReason::kFinished;
  std::string message;  ///< why not finished
  int signal = 0;
  bool right_side = false;
  int our_score = 0;
  int their_score = 0;
  int cycles = 0;
  std::vector<PlayerResult> players;
  ErrorResult errors;       ///< of the Playmaker
  std::string write_error;  ///< why a debug or offline log is not complete; empty: it is
};

/// The document `cls.proxy/1`, indented, with a newline at its end.
std::string to_json(const StandaloneTeamOptions& options, const StandaloneTeamResult& result);

/// Waits for the server, joins, plays until the match is over and the server stops responding,
/// leaves. A match with one side: see Match.
StandaloneTeamResult run_standalone_team(const StandaloneTeamOptions& options,
                                         MatchObserver& observer,
                                         const std::atomic<int>& stop_signal);

}  // namespace cls::match
