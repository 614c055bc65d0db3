// The table of all keys of [tournament]: name, help, parser and formatter.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "tournament/config/config.h"
#include "tournament/config/config_values.h"

namespace cls::tournament {

enum class KeyGroup {
  kSchedule,    ///< which teams play each other
  kConditions,  ///< how a match is played
  kExecution,   ///< how the schedule is executed; not part of the plan
  kReport,      ///< how the tournament is presented; not part of the plan
};

struct ConfigKey {
  std::string_view name;
  KeyGroup group;
  std::string_view help;         ///< one line for --help and the commented file
  std::string_view example;      ///< a value as TOML
  std::string_view placeholder;  ///< of the value in --help: "N"
  ReadText read;                 ///< of a value on the command line
  /// Stores the value. The error names the accepted values ("must be a whole number from 1").
  std::function<base::Result<void>(TournamentConfig&, const ConfigValue&)> parse;
  /// The value as TOML; empty when it is not set.
  std::function<std::string(const TournamentConfig&)> format;
};

/// In the order of the written file.
const std::vector<ConfigKey>& tournament_keys();

/// nullptr when there is none.
const ConfigKey* find_key(std::string_view name);

/// "unknown key 'ronds'; did you mean 'rounds'?"
std::string unknown_key(std::string_view what, std::string_view name,
                        const std::vector<std::string_view>& known);

}  // namespace cls::tournament
