// Usage errors as one sentence: the option or command, the value, the accepted form.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace cls::cli {

/// "cls check perception".
std::string full_name(const CLI::App& command);

/// The error of the first argument that names no command of `app`; nothing if all commands are
/// known.
std::optional<std::string> unknown_command(const CLI::App& app,
                                           const std::vector<std::string>& arguments);

/// "unknown option '--sed'; did you mean '--seed'?"
std::string unknown_option(const CLI::App& command, const std::string& option);

/// The sentence for an error of the parser.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace cls::cli
