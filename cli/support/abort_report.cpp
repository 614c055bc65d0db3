// Signal handlers may only call a few functions: the line is made beforehand.
#include "cli/support/abort_report.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "base/system/control_group.h"
#include "cli/support/print_error.h"

namespace cls::cli {
namespace {

struct AbortReport {
  std::string line;
  bool limited = false;  ///< the limits of memory explain the abort
};

std::string limit_text(int resource, const char* option, unsigned long unit) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 ||
      limit.rlim_cur == RLIM_INFINITY) {
    return "";
  }
  return fmt::format(" ulimit -{} {}", option, limit.rlim_cur / unit);
}

AbortReport make_abort_report() {
  const std::string memory = limit_text(RLIMIT_AS, "v", 1024) + limit_text(RLIMIT_DATA, "d", 1024);
  std::string limits = memory + limit_text(RLIMIT_NPROC, "u", 1);
  if (const auto most = base::process_limit()) {
    limits += fmt::format(" pids.max {} of the control group", *most);
  }
  return {
      fmt::format("cls: a library ended the process, as it does without memory or threads{}{}\n",
                  limits.empty() ? "" : "; limits of this shell:", limits),
      !memory.empty()};
}

const AbortReport& abort_report() {
  static const AbortReport made = make_abort_report();
  return made;
}

// The children that cls forks for a moment have the handler, too, and say the same.
void on_abort(int) {
  [[maybe_unused]] const auto written =
      write(STDERR_FILENO, abort_report().line.data(), abort_report().line.size());
  if (abort_report().limited) _exit(kInternalError);
  std::signal(SIGABRT, SIG_DFL);
  std::raise(SIGABRT);
}

[[noreturn]] void on_terminate() {
  if (const std::exception_ptr current = std::current_exception()) {
    try {
      std::rethrow_exception(current);
    } catch (const std::exception& error) {
      _exit(print_exception(error));
    } catch (...) {
    }
  }
  std::abort();
}

}  // namespace

std::string too_low_limit() {
  struct Need {
    int resource;
    const char* option;
    rlim_t least;
    rlim_t unit;  ///< of `ulimit`, in bytes
  };
  constexpr Need kNeeds[] = {{RLIMIT_NOFILE, "n", 32, 1}, {RLIMIT_STACK, "s", 512 << 10, 1024}};
  for (const Need& need : kNeeds) {
    rlimit limit{};
    const auto resource = static_cast<__rlimit_resource_t>(need.resource);
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur >= need.least) continue;
    return fmt::format("ulimit -{} {} is too low: cls needs {}; raise it: ulimit -{} {}",
                       need.option, limit.rlim_cur / need.unit, need.least / need.unit, need.option,
                       16 * need.least / need.unit);
  }
  return {};
}

void report_aborts() {
  abort_report();
  std::set_terminate(on_terminate);
  std::signal(SIGABRT, on_abort);
}

}  // namespace cls::cli
