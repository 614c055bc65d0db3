// The errors of a wrong command line, one line each.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

/// "--seed 'x': must be a whole number, 0 or more"
std::string invalid_value(const Command& command, const Option& option, const std::string& value);

/// "--seed is given 2 times; only once is possible"
std::string given_too_often(const Option& option);

/// An option without its value, or a flag with one.
std::string wrong_count(const Command& command, const Option& option);

/// The required options that are not given; empty: none.
std::string missing_options(const Command& command);

/// For a command that needs one below it.
std::string missing_command(const Command& command);

/// A word that the command does not take: an option or an argument.
std::string unknown_word(const Command& command, const std::string& word);

/// "unknown option '--sed'; did you mean '--seed'?". `option` may contain a value: "--sed=1".
std::string unknown_option(const Command& command, const std::string& option);

/// An error for the first word that names no command where one is required. CLI11 reports nothing
/// below a command that it does not know.
std::string unknown_command(const Command& root, const std::vector<std::string>& words);

/// The last resort.
std::string wrong_arguments(const Command& command);

}  // namespace cls::cli
