// The command that starts a soccer server as a process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "match/terms/server_choice.h"
#include "process/command_plan.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::match {

/// The UDP ports of a soccer server.
struct ServerPorts {
  int player = 6000;  ///< players and monitors
  int trainer = 6001;
  int coach = 6002;
};

/// The settings of a server process.
struct ServerSetup {
  std::vector<std::string> program;  ///< path, and arguments before the options
  std::filesystem::path folder;      ///< match folder: logs, server.log, server-conf/
  ServerPorts ports;
  MatchMode mode = MatchMode::kSynch;
  soccer::ServerParams server;  ///< from the options
  soccer::PlayerParams player;
  std::vector<int> cpus;
};

/// Names inside the match folder.
inline constexpr const char* kServerLog = "server.log";
inline constexpr const char* kServerConfiguration = "server-conf";

/// The plan that starts it: parameters that the match needs (auto mode, ports, synch mode, log
/// names), then every other parameter that differs from its default. The server runs in the match
/// folder, so that log folders need no quoting, with its own configuration folder (RCSS_CONF_DIR):
/// the user's ~/.rcssserver is neither read nor written. It waits for players as long as the match.
process::CommandPlan server_plan(const ServerSetup& setup);

/// Environment of a server that is started in `folder`: its configuration folder, and no user name,
/// with which it would find the configuration of old versions in the user's home.
std::vector<process::EnvironmentChange> server_environment(const std::filesystem::path& folder);

/// `server::name=value` as rcssserver parses it; two arguments where one would be misread.
std::vector<std::string> server_argument(const std::string& name, const std::string& value,
                                         bool is_text);

}  // namespace cls::match
