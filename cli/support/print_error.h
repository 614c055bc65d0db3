// Error lines on stderr.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::cli {

/// Prints "cls: MESSAGE" to stderr and returns `exit_code`.
int print_error(int exit_code, std::string_view message);

/// One line per message.
int print_errors(int exit_code, const std::vector<std::string>& messages);

}  // namespace cls::cli
