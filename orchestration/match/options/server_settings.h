// Everything that can be said about a soccer server in rcssserver's language.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::orchestration::match {

/// The version that configuration files must be of.
inline constexpr const char* kConfigurationVersion = "19.0.0";

/// Defaults are rcssserver's.
struct ServerSettings {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  bool save_csv = false;  ///< CSVSaver::save
  std::string csv_file = "rcssserver.csv";
  int max_wait_ms = 1250;  ///< sync::max_wait_ms: for (done) in synchronous mode
  int max_missed = 20;     ///< sync::max_missed: cycles in a row, more end the match
  bool help = false;       ///< it was asked for
};

/// Applies `server::NAME=VALUE`, `player::`, `CSVSaver::`, `sync::` and `include=FILE` in their
/// order. The error names the word, and the file and line if it is in a file.
base::Result<void> apply_arguments(ServerSettings& settings,
                                   const std::vector<std::string>& arguments);

/// Applies a configuration file. Its `MODULE::version` must be kConfigurationVersion, if given.
base::Result<void> apply_file(ServerSettings& settings, const std::filesystem::path& file);

/// Applies server.conf, player.conf and CSVSaver.conf of the folder, those that there are. Returns
/// their paths. Nothing is created.
base::Result<std::vector<std::filesystem::path>> apply_folder(ServerSettings& settings,
                                                              const std::filesystem::path& folder);

/// Where rcssserver looks for them: RCSS_CONF_DIR, else ~/.rcssserver; empty if neither is known.
std::filesystem::path configuration_folder();

}  // namespace cls::orchestration::match
