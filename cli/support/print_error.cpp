// Error lines on stderr.
#include "cli/support/print_error.h"

#include <fmt/format.h>

#include <cstdio>

#include "cli/terminal/terminal.h"

namespace cls::cli {

int print_error(int exit_code, std::string_view message) {
  fmt::print(stderr, "{}", message_line(message));
  return exit_code;
}

int print_errors(int exit_code, const std::vector<std::string>& messages) {
  for (const std::string& message : messages) print_error(exit_code, message);
  return exit_code;
}

}  // namespace cls::cli
