// Settings of `cls server` in the syntax of rcssserver.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/terms/bound_sides.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::match {

/// Required version of configuration files.
inline constexpr const char* kConfigurationVersion = "19.0.0";

/// For how long rcssserver in synch mode waits for the (done) of its clients, by default.
inline constexpr std::chrono::milliseconds kServerWait{1250};

/// Defaults are rcssserver's.
struct ServerSettings {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  bool save_csv = false;  ///< CSVSaver::save
  std::string csv_file = "rcssserver.csv";
  int max_wait_ms = kServerWait.count();  ///< sync::max_wait_ms
  int max_missed = 20;                    ///< sync::max_missed: cycles in a row, more end the match
  std::optional<BoundSides> bound;        ///< match::sides: of a server that a match has started
  bool help = false;                      ///< --help was given
};

/// `match::sides=...`, with which a match starts its server.
std::string bound_sides_argument(const BoundSides& sides);

/// Applies `server::NAME=VALUE`, `player::`, `CSVSaver::`, `sync::` and `include=FILE` in sequence.
/// The error names the argument, or file and line.
base::Result<void> apply_arguments(ServerSettings& settings,
                                   const std::vector<std::string>& arguments);

/// Applies a configuration file. Its `MODULE::version` must be kConfigurationVersion, if given.
base::Result<void> apply_file(ServerSettings& settings, const std::filesystem::path& file);

/// Applies those of server.conf, player.conf and CSVSaver.conf that exist in the folder, and
/// returns their paths. Creates nothing.
base::Result<std::vector<std::filesystem::path>> apply_folder(ServerSettings& settings,
                                                              const std::filesystem::path& folder);

/// Configuration folder of rcssserver: RCSS_CONF_DIR, otherwise ~/.rcssserver; empty if unknown.
std::filesystem::path configuration_folder();

}  // namespace cls::match
