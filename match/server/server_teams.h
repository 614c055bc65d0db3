// Teams that `cls server` starts: server::team_l_start and team_r_start.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "match/programs/server_plan.h"
#include "process/process_host.h"
#include "soccer/parameters/server_params.h"
#include "soccer/per_side.h"

namespace cls::match {

/// Starts each side once with /bin/sh -c when rcssserver would: never in play_on, and the right
/// side after the left one has connected, because the first to connect is left. Their output goes
/// to stdout. Problems are reported on stderr; the match continues without the team. Not
/// thread-safe.
class ServerTeams {
 public:
  /// The teams get the ports in CLS_SERVER_PORT, CLS_SERVER_COACH_PORT and CLS_SERVER_OLCOACH_PORT.
  /// The error says why no process can be started; without teams to start there is none.
  static base::Result<ServerTeams> create(const soccer::ServerParams& params,
                                          const ServerPorts& ports);

  /// Call after every step.
  void poll(bool play_is_on, bool left_has_connected);

  /// Sends SIGINT to each start command, like rcssserver, terminates what is left, and waits.
  void terminate();

 private:
  struct Team {
    process::CommandPlan plan;
    std::shared_ptr<process::Child> child;  ///< once started
    bool tried = false;
    bool reported = false;  ///< its failure
  };

  void start(Team& team);
  void report_failures();
  static void report_failure(Team& team);

  std::optional<process::ProcessHost> host_;  ///< if there is something to start
  soccer::PerSide<Team> teams_;
  std::uint64_t seen_changes_ = 0;
};

}  // namespace cls::match
