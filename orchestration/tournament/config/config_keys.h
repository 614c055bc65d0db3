// The table of all keys of [tournament]: what each is called, means, accepts and how it is written.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"

namespace cls::orchestration::tournament {

/// A value as it stands in a file or on the command line.
using ConfigValue = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>,
                                 std::vector<std::vector<std::string>>>;

enum class KeyGroup {
  kSchedule,    ///< who plays whom
  kConditions,  ///< how a match is played
  kExecution,   ///< how the schedule is worked off; no part of the plan
};

struct ConfigKey {
  std::string_view name;
  KeyGroup group;
  std::string_view meaning;  ///< one line for help and the commented file
  std::string_view example;  ///< a value as TOML
  /// Takes the value over, or says what the key accepts ("must be a whole number from 1").
  std::function<base::Result<void>(TournamentConfig&, const ConfigValue&)> read;
  /// The value as TOML, empty when it is not set.
  std::function<std::string(const TournamentConfig&)> write;
};

/// In the order in which they are written.
const std::vector<ConfigKey>& tournament_keys();

/// nullptr when there is none.
const ConfigKey* find_key(std::string_view name);

/// `text` from the command line as the value it looks like: true, 12, 0.5, a,b,c or a word.
/// `key` decides where several are possible.
ConfigValue value_from_text(const ConfigKey& key, std::string_view text);

/// "unknown key 'ronds'; did you mean 'rounds'?"
std::string unknown_key(std::string_view what, std::string_view word,
                        const std::vector<std::string_view>& known);

/// A string as a TOML basic string, quotes included.
std::string toml_quoted(std::string_view text);

}  // namespace cls::orchestration::tournament
