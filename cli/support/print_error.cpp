// Error lines on stderr.
#include "cli/support/print_error.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

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

int print_exception(const std::exception& error) {
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    if (file->path1().empty() && file->code() == std::errc::no_such_file_or_directory) {
      return print_error(kNoInput, "the working folder does not exist any more; go to another one");
    }
    return print_error(kNoInput,
                       fmt::format("{}: {}", file->path1().string(), file->code().message()));
  }
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) {
    if (system->code() == std::errc::resource_unavailable_try_again) {
      return print_error(kInternalError, "out of memory or processes: cannot start a thread");
    }
  }

  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return print_error(kInternalError, "out of memory");
  }

  return print_error(kInternalError, fmt::format("internal error: {}", error.what()));
}

}  // namespace cls::cli
