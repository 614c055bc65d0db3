// Groups and placeholders of options, and the flags that every command has.
#pragma once

#include "cli/command/command.h"

namespace cls::cli {

/// Completes the commands below `root`, when all of them have been added: group and placeholder of
/// each option (those of options of matches from their table), --quiet and --no-color for every
/// command.
void complete_commands(Command& root);

}  // namespace cls::cli
