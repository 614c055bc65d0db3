// Options of commands that are rows of the table of match options.
#pragma once

#include <string_view>

#include "cli/command/command.h"
#include "match/terms/option_table.h"

namespace cls::cli {

/// Adds the option; its values stay in Option::given.
Option& add_match_option(Command& command, const match::MatchOption& row);

/// Adds the option of that key, whose value goes to `target`.
template <class T>
Option& add_match_option(Command& command, std::string_view key, T& target) {
  Option& option = add_match_option(command, *match::find_match_option(key));
  option.target = &target;
  return option;
}

}  // namespace cls::cli
