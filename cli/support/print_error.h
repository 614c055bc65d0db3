// Error lines on stderr.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace cls::cli {

/// Prints "cls: MESSAGE" to stderr and returns `exit_code`.
int print_error(int exit_code, std::string_view message);

/// One line per message.
int print_errors(int exit_code, const std::vector<std::string>& messages);

/// The line of an exception that nothing has caught, as an internal error if none of its known
/// causes; returns the exit code of `cls`.
int print_exception(const std::exception& error);

}  // namespace cls::cli
