// Options shared by `cls tournament` commands: the configuration and its overrides.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/command/command.h"
#include "tournament/config/config.h"

namespace cls::cli {

struct TournamentOptions {
  std::string folder;
  std::string config_file;
  std::map<std::string, std::string> overrides;  ///< value by key of [tournament]; empty: not given
  std::vector<std::string> teams;                ///< NAME=ENDPOINT
  std::vector<std::string> settings;             ///< server::NAME=VALUE
};

/// True when the command line gives this key of [tournament].
bool is_given(const TournamentOptions& options, const std::string& key);

/// Adds DIR, --config, --team, --set and one option for every key of [tournament] to `command`;
/// `options` must outlive it.
void add_tournament_options(Command& command, TournamentOptions& options);

/// Like add_tournament_options, without DIR and --config.
void add_override_options(Command& command, TournamentOptions& options);

/// Like add_tournament_options, without DIR, --team and the schedule keys except the seed; for
/// commands with their own schedule.
void add_condition_options(Command& command, TournamentOptions& options);

/// A configuration, or an exit code whose error is already printed.
struct ChosenConfig {
  int exit_code = 0;
  tournament::TournamentConfig config;
};

/// Reads --config, else cls.toml in DIR, else cls.toml in or above the working directory, else the
/// plan in DIR; then applies the overrides. Prints errors, one line each.
ChosenConfig choose_config(const TournamentOptions& options);

/// Like choose_config, but requires no teams and no schedule; empty without a file.
ChosenConfig choose_conditions(const TournamentOptions& options);

}  // namespace cls::cli
