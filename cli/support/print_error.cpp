// Error lines on stderr.
#include "cli/support/print_error.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

#include "base/system/control_group.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {

namespace {

// "; limits: ulimit -u 20, pids.max 12 of the control group".
std::string process_limits() {
  std::vector<std::string> limits;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NPROC, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    limits.push_back(fmt::format("ulimit -u {}", limit.rlim_cur));
  }
  if (const auto most = base::process_limit()) {
    limits.push_back(fmt::format("pids.max {} of the control group", *most));
  }
  return limits.empty() ? "" : fmt::format("; limits: {}", fmt::join(limits, ", "));
}

}  // namespace

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
      return print_error(kTryAgain,
                         "out of memory or processes: cannot start a thread" + process_limits());
    }
  }

  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return print_error(kInternalError, "out of memory");
  }

  return print_error(kInternalError, fmt::format("internal error: {}", error.what()));
}

}  // namespace cls::cli
