// Options that scripts say to the framework's proxy and that mean nothing to ours.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cls::cli {

/// Lets `command` accept them, in a group of their own.
void add_script_options(CLI::App& command);

/// Those that the user gave: "--offline-logging".
std::vector<std::string> given_script_options(const CLI::App& command);

}  // namespace cls::cli
