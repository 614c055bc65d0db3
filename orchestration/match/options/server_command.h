// How a soccer server that is a program of its own is started.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "orchestration/match/options/server_choice.h"
#include "orchestration/process/command_plan.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::orchestration::match {

/// The UDP ports of a soccer server.
struct ServerPorts {
  int player = 6000;  ///< players and monitors
  int trainer = 6001;
  int coach = 6002;
};

/// Everything about a server process that the match decides.
struct ServerSetup {
  std::vector<std::string> program;  ///< path, and what must come before the options
  std::filesystem::path folder;      ///< match folder: logs, server.log, server-conf/
  ServerPorts ports;
  MatchMode mode = MatchMode::kSynch;
  soccer::ServerParams server;  ///< as the user wants them
  soccer::PlayerParams player;
  std::vector<int> cpus;
};

/// Names inside the match folder.
inline constexpr const char* kServerLog = "server.log";
inline constexpr const char* kServerConfiguration = "server-conf";

/// The plan that starts it: what the match needs (auto mode, ports, synch mode, log names), then
/// every parameter that differs from the stock one. It runs in the match folder, so that log
/// folders need no quoting, and with a configuration folder of its own (RCSS_CONF_DIR), so that
/// the user's ~/.rcssserver is neither read nor written. Nobody joins late by accident: it waits
/// for all players as long as the match does.
process::CommandPlan server_plan(const ServerSetup& setup);

/// What a server that is started in `folder` finds in its environment: that folder for its
/// configuration, and no user name, by which it would find that of old versions in the user's home.
std::vector<process::EnvironmentChange> server_environment(const std::filesystem::path& folder);

/// `server::name=value` as rcssserver reads it; two words where one would be misread.
std::vector<std::string> server_argument(const std::string& name, const std::string& value,
                                         bool is_text);

}  // namespace cls::orchestration::match
