// Options that `cls tournament` commands share: which configuration, and what overrides it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"

namespace CLI {
class App;
}

namespace cls::cli {

struct TournamentOptions {
  std::string folder;
  std::string config_file;
  std::map<std::string, std::string> overrides;  ///< value by key of [tournament]
  std::vector<std::string> teams;                ///< NAME=ENDPOINT
  std::vector<std::string> settings;             ///< server::NAME=VALUE
};

/// Adds DIR, --config, --team, --set and one option for every key of [tournament] to `command`;
/// `options` must outlive it.
void add_tournament_options(CLI::App& command, TournamentOptions& options);

/// The options of add_tournament_options but DIR, --team and those keys that make a schedule other
/// than the seed: for commands with a schedule of their own.
void add_condition_options(CLI::App& command, TournamentOptions& options);

/// A configuration, or an exit code with its reason already printed.
struct ChosenConfig {
  int exit_code = 0;
  orchestration::tournament::TournamentConfig config;
};

/// --config, else cls.toml in DIR, else cls.toml upward from the working directory, else the plan
/// that DIR holds; then the overrides. Prints what is wrong, one line each.
ChosenConfig choose_config(const TournamentOptions& options);

/// The same without the demand that there are teams and a schedule; without a file it is empty.
ChosenConfig choose_conditions(const TournamentOptions& options);

/// Prints one line to stderr and returns `exit_code`.
int complain(int exit_code, const std::string& message);

}  // namespace cls::cli
