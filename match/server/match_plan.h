// The plan of a match over UDP: programs, ports and folders, before anything is started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/programs/server_plan.h"
#include "match/programs/team_folder.h"
#include "match/terms/match_options.h"
#include "process/ports.h"
#include "soccer/per_side.h"

namespace cls::match {

/// Where a server and, in a network of its own, an external team find each other.
inline constexpr const char* kLoopback = "127.0.0.1";

/// The programs and ports of a match; `--dry-run` prints them.
struct MatchPlan {
  std::string server_host = kLoopback;
  ServerPorts ports;
  std::optional<process::CommandPlan> server;      ///< none: the server runs already
  soccer::PerSide<std::optional<TeamPlan>> teams;  ///< of `team:` sides
  std::vector<process::ReservedPort> reserved;     ///< held for the server
};

/// Finds programs and folders and chooses ports: player, trainer and coach port in a row. With a
/// team whose start script takes no ports the server gets 6000, 6001 and 6002, with other external
/// teams too if they are free. The error says what is missing.
base::Result<MatchPlan> plan_match(const MatchOptions& options, const TeamNames& names,
                                   std::uint64_t seed, const std::filesystem::path& folder);

/// The arguments of the start script of an external team.
TeamValues team_values(const MatchOptions& options, const TeamNames& names, soccer::Side side,
                       const std::string& host, const ServerPorts& ports,
                       const std::filesystem::path& folder);

/// Names the first port of the plan that is in use, and its owner; empty when all are free.
std::string port_in_use(const MatchPlan& plan);

}  // namespace cls::match
