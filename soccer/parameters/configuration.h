// rcssserver's language of parameters, in files and on its command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::soccer {

/// `MODULE::NAME = VALUE`, `include = FILE` or `help`; the dashes that may stand before it are
/// gone.
struct ConfigurationItem {
  std::string module;  ///< empty where none is written
  std::string name;
  std::string value;  ///< without its quotes; empty for help
  int line = 1;
};

/// Reads items separated by blanks and line ends; blanks may stand around the '=', comments
/// (`/* */`, `//`, `#`) between words (protocol 10.2). More lenient than the real server where it
/// trips over itself: an unquoted value may begin like a number or a word (`2024abc`) and hold a
/// colon. The error names the line.
base::Result<std::vector<ConfigurationItem>> parse_configuration(std::string_view text);

/// A command line as one such text. An argument with blanks is taken as one value even without
/// quotes.
std::string join_arguments(const std::vector<std::string>& arguments);

}  // namespace cls::soccer
