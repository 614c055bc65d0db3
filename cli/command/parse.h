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
Parsed parse(Command& root, std::vector<std::string> words);

/// "unknown option '--sed'; did you mean '--seed'?". `option` may contain a value: "--sed=1".
std::string unknown_option(const Command& command, const std::string& option);

/// An error for the first word that names no command where one is required. CLI11 reports nothing
/// below a command that it does not know.
std::string unknown_command(const Command& root, const std::vector<std::string>& words);

}  // namespace cls::cli
