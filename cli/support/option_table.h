// Groups and placeholders of options and commands, and the options that every command has.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Completes the commands below `app`, when all of them have been added: group and placeholder of
/// each option, strict numbers, --quiet and --no-color for every command.
void complete_commands(CLI::App& app);

}  // namespace cls::cli
