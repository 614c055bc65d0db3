// A team of ours on a soccer server that somebody else runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "orchestration/match/result/end_reason.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::orchestration::match {

struct LoneTeamOptions {
  std::string server_host = "localhost";
  int server_port = 6000;
  int coach_port = 0;    ///< 0: no coach
  int trainer_port = 0;  ///< 0: no trainer
  proxy::GrpcTarget playmaker;
  bool add_20_for_right = false;  ///< a team on the right asks at ports that are 20 higher
  proxy::TeamOptions team;
  double start_timeout_s = 20.0;  ///< until the server must answer
  /// Called once, when the players are on the pitch and the Playmaker knows them; may be empty.
  std::function<void(const proxy::Team&)> on_ready;
};

/// What a team came to; the score as it heard it.
struct LoneTeamResult {
  EndReason end_reason = EndReason::kFinished;
  std::string message;  ///< why not finished
  int signal = 0;
  bool right_side = false;
  int our_score = 0;
  int their_score = 0;
  int cycles = 0;
  std::vector<PlayerResult> players;
};

/// The document `cls.proxy/1`, indented, with a newline at its end.
std::string to_json(const LoneTeamOptions& options, const LoneTeamResult& result);

/// Waits for the server, joins, plays until the match is over and the server silent, leaves.
LoneTeamResult run_lone_team(const LoneTeamOptions& options, MatchObserver& observer,
                             const std::atomic<int>& stop_signal);

}  // namespace cls::orchestration::match
