// Parameter syntax of rcssserver's configuration files and command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::soccer {

/// `MODULE::NAME = VALUE`, `include = FILE` or `help`, without leading dashes.
struct ConfigurationItem {
  std::string module;  ///< empty if absent
  std::string name;
  std::string value;  ///< without quotes; empty for help
  int line = 1;
};

/// Parses items separated by white space, with optional white space around '=' and comments
/// (`/* */`, `//`, `#`) between tokens (docs/spec/server-protocol.md 10.2). Accepts unquoted values
/// that rcssserver rejects: those that begin like a number (`2024abc`) or contain a colon. The
/// error names the line.
base::Result<std::vector<ConfigurationItem>> parse_configuration(std::string_view text);

/// Joins command line arguments into configuration text; arguments with spaces become quoted
/// values.
std::string join_arguments(const std::vector<std::string>& arguments);

}  // namespace cls::soccer
