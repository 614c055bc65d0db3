// Collects the lines of one child.
#include "cli/support/run_program.h"

#include <fmt/format.h>

#include <mutex>
#include <string_view>
#include <utility>

#include "process/process_host.h"

namespace cls::cli {

using base::Result;

Result<std::vector<std::string>> run_program(const std::string& name, std::vector<std::string> argv,
                                             std::chrono::seconds limit) {
  process::CommandPlan plan;
  plan.name = name;
  plan.argv = std::move(argv);

  std::mutex mutex;
  std::vector<std::string> lines;
  TRY_INIT(auto host, process::ProcessHost::create());
  TRY_INIT(const auto child, host.start(plan, [&](std::string_view line) {
    const std::lock_guard lock(mutex);
    lines.emplace_back(line);
  }));

  const bool ended = child->wait_exit(limit);
  child->wait_gone(std::chrono::milliseconds(1000));
  host.end_all(std::chrono::milliseconds(200));
  const auto status = child->status();
  const std::lock_guard lock(mutex);
  const std::string last = lines.empty() ? std::string() : ": " + lines.back();
  if (!ended || !status.exit) {
    return base::Error{
        fmt::format("{}: did not end within {} s{}", plan.name, limit.count(), last)};
  }
  if (status.exit->by_signal || status.exit->number != 0) {
    return base::Error{fmt::format("{}: {}{}", plan.name, to_text(*status.exit), last)};
  }
  return lines;
}

}  // namespace cls::cli
