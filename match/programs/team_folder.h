// `team:DIR` sides: the commands that start and stop an external team.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/programs/server_plan.h"
#include "match/terms/endpoint.h"
#include "process/command_plan.h"
#include "soccer/side.h"

namespace cls::match {

/// The arguments and surroundings of the start script of an external team.
struct TeamValues {
  std::string host = "127.0.0.1";
  ServerPorts ports;
  soccer::Side side = soccer::Side::kLeft;
  std::string team_name;         ///< for teams that take one
  bool coach = true;             ///< start its online coach too
  std::filesystem::path folder;  ///< match folder, for the logs
  std::vector<int> cpus;
  process::ResourceLimits limits;
  bool sandbox = false;                       ///< see team_files() and team_environment()
  bool namespaces = false;                    ///< its programs will start in namespaces
  std::vector<std::filesystem::path> hidden;  ///< folders of other external teams
};

/// One process of a team.
struct AgentPlan {
  int unum = 0;  ///< 12: the coach; 0: the whole team
  process::CommandPlan command;
};

/// The commands of one team.
struct TeamPlan {
  /// `start` is called once per agent and stays; `start.sh` starts all and may return.
  enum class Contract { kStartEachAgent, kStartAll };

  Contract contract = Contract::kStartEachAgent;
  std::vector<AgentPlan> agents;            ///< goalie first, coach last; kStartAll: one plan
  std::vector<process::CommandPlan> kills;  ///< called at the end; cls ends what they leave
  bool mixed = false;                       ///< its agents are those of several teams
  bool takes_ports = false;                 ///< otherwise the server must use 6000, 6001 and 6002
  int coach_port = 0;                       ///< where its coach should join; 0: without a coach
  bool takes_name = false;                  ///< otherwise the team chooses its name
  bool own_network = false;                 ///< where the server has its usual ports
};

/// Reads folder DIR: `start` (called as `start HOST DIR NUM PORT COACHPORT`, NUM 1 for the goalie
/// to 11, 12 for the coach) or, without one, `start.sh` (called with -h HOST -p PORT -P COACHPORT
/// -t NAME), and `kill`. The error says what is missing.
base::Result<TeamPlan> team_plan(const std::filesystem::path& team, const TeamValues& values);

/// The plan of a side `team:DIR`, or of a mixed one: each agent is that of its part, started by
/// the `start` of that team with its own number. A part with start.sh alone is an error.
base::Result<TeamPlan> team_plan(const Endpoint& side, const TeamValues& values);

/// The folders of an external side; none for another one.
std::vector<std::filesystem::path> team_folders(const Endpoint& side);

}  // namespace cls::match
