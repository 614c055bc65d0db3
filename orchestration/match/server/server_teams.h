// The teams that a soccer server starts itself: server::team_l_start and team_r_start.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "orchestration/match/options/server_command.h"
#include "orchestration/process/process_host.h"
#include "soccer/parameters/server_params.h"

namespace cls::orchestration::match {

/// Starts each side by /bin/sh -c when rcssserver would: never while play is on, each once, the
/// right one when the left one is there, since the first to connect is the left one. What they
/// print goes to our stdout. Problems are lines on stderr; the match goes on without the team.
/// Used by one thread at a time.
class ServerTeams {
 public:
  /// The teams find the ports in CLS_SERVER_PORT, CLS_SERVER_COACH_PORT and
  /// CLS_SERVER_OLCOACH_PORT, since port 0 tells nothing. The error says why nothing can be
  /// started here; where no team is to be started there is none.
  static base::Result<ServerTeams> create(const soccer::ServerParams& params,
                                          const ServerPorts& ports);

  /// To be called after every step.
  void look(bool play_is_on, bool left_is_here);

  /// SIGINT to each start command, as rcssserver does, then whatever it takes until nothing of them
  /// is left. Waits for that.
  void end();

 private:
  struct Team {
    process::CommandPlan plan;
    std::shared_ptr<process::Child> child;  ///< once started
    bool tried = false;
    bool told = false;  ///< that it has failed
  };

  void start(Team& team);
  void tell_failures();

  std::optional<process::ProcessHost> host_;  ///< if there is something to start
  std::array<Team, 2> teams_;
  std::uint64_t seen_changes_ = 0;
};

}  // namespace cls::orchestration::match
