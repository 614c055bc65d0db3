// The errors of a wrong command line, one line each.
#pragma once

#include <string>
#include <string_view>

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

/// The last resort.
std::string wrong_arguments(const Command& command);

/// The first option that a text names; nullptr if there is none.
const Option* option_in(const Command& command, std::string_view text);

}  // namespace cls::cli
