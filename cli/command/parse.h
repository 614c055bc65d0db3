// Parses the words of a command line into the tree of commands.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

struct Parsed {
  const Command* command = nullptr;  ///< the innermost that the words name
  bool asks_for_help = false;
  std::string error;  ///< one line; empty: the options have their values
};

/// Stores the values of the words, which lack the program's name, in the targets of the options.
Parsed parse(Command& root, const std::vector<std::string>& words);

}  // namespace cls::cli
