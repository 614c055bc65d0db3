// The table of all keys of [tournament]: name, help, parser and formatter.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// A value in a file or on the command line.
using ConfigValue = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>,
                                 std::vector<std::vector<std::string>>, std::vector<std::int64_t>>;

enum class KeyGroup {
  kSchedule,    ///< which teams play each other
  kConditions,  ///< how a match is played
  kExecution,   ///< how the schedule is executed; not part of the plan
  kReport,      ///< how the tournament is presented; not part of the plan
};

struct ConfigKey {
  std::string_view name;
  KeyGroup group;
  std::string_view help;     ///< one line for --help and the commented file
  std::string_view example;  ///< a value as TOML
  /// Stores the value. The error names the accepted values ("must be a whole number from 1").
  std::function<base::Result<void>(TournamentConfig&, const ConfigValue&)> parse;
  /// The value as TOML; empty when it is not set.
  std::function<std::string(const TournamentConfig&)> format;
};

/// In the order of the written file.
const std::vector<ConfigKey>& tournament_keys();

/// nullptr when there is none.
const ConfigKey* find_key(std::string_view name);

/// Parses a value from the command line: true, 12, 0.5, a,b,c or a string. `key` decides where
/// several types are possible.
ConfigValue parse_config_value(const ConfigKey& key, std::string_view text);

/// "unknown key 'ronds'; did you mean 'rounds'?"
std::string unknown_key(std::string_view what, std::string_view name,
                        const std::vector<std::string_view>& known);

/// A string as a TOML basic string, quotes included.
std::string toml_quoted(std::string_view text);

}  // namespace cls::tournament
