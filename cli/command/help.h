// The help of a command as text, and its parts for manual pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

/// Description, usage, arguments, options by group, commands.
std::string help_text(const Command& command);

/// A text up to its first line feed.
std::string first_line(std::string_view text);

/// What follows the name: "[OPTIONS] LEFT RIGHT".
std::string usage_of(const Command& command);

/// "-p,--port N"; "LOG ..." of an argument that repeats.
std::string signature_of(const Option& option);

/// The help with environment and default value.
std::string description_of(const Option& option);

/// The groups in the order of the help, "Output" last; hidden ones left out.
std::vector<std::string> option_groups(const Command& command);

}  // namespace cls::cli
