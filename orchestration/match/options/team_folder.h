// `team:DIR` sides: how a foreign team is started and ended.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/server_command.h"
#include "orchestration/process/command_plan.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// What a foreign team is told.
struct TeamValues {
  std::string host = "127.0.0.1";
  ServerPorts ports;
  soccer::Side side = soccer::Side::kLeft;
  std::string team_name;         ///< for teams that take one
  bool coach = true;             ///< start the coach too
  std::filesystem::path folder;  ///< match folder, for the logs
  std::vector<int> cpus;
};

/// How one team is started.
struct TeamPlan {
  /// `start` is called once per agent and stays; `start.sh` starts all and may return.
  enum class Contract { kStartEachAgent, kStartAll };

  Contract contract = Contract::kStartEachAgent;
  std::vector<process::CommandPlan> agents;  ///< goalie first, the coach last; kStartAll: one plan
  std::optional<process::CommandPlan> kill;  ///< to be called at the end, not to be relied on
  bool takes_ports = false;                  ///< else the server must be at 6000, 6001 and 6002
  bool takes_name = false;                   ///< else the team names itself
};

/// Looks at DIR: `start` (called as `start HOST DIR NUM`, NUM 1 for the goalie to 11, 12 for the
/// coach) or, without one, `start.sh` (called with -h HOST -p PORT -P COACHPORT -t NAME), and
/// `kill`. The error says what is missing.
base::Result<TeamPlan> team_plan(const std::filesystem::path& team, const TeamValues& values);

}  // namespace cls::orchestration::match
