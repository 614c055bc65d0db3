// Starts hooks as child processes with a file as standard input.
#include "orchestration/tournament/run/hook.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/io/whole_file.h"

namespace cls::orchestration::tournament {
namespace {

constexpr std::chrono::milliseconds kHookExitTimeout{60'000};

}  // namespace

HookRunner::~HookRunner() {
  std::error_code code;
  for (const Running& one : running_) {
    one.child->end(std::chrono::milliseconds(0));
    std::filesystem::remove(one.document, code);
  }
}

void HookRunner::start(const std::string& name, const std::string& command,
                       const std::string& document) {
  const std::filesystem::path file =
      std::filesystem::absolute(folder_) / fmt::format(".hook-{}.json", ++started_);
  if (const auto written = base::write_file(file, document); !written) {
    errors_.push_back(written.error().message);
    return;
  }
  if (!host_) {
    auto created = process::ProcessHost::create();
    if (!created) {
      errors_.push_back(created.error().message);
      return;
    }
    host_.emplace(*std::move(created));
  }
  const std::string line =
      fmt::format("exec <{}\n{}", process::shell_quoted(file.string()), command);
  process::CommandPlan plan = process::shell_command(name, line);
  plan.folder = working_folder_;
  auto child = host_->start(plan);
  if (!child) {
    errors_.push_back(child.error().message);
    return;
  }
  running_.push_back({*std::move(child), file});
}

std::vector<std::string> HookRunner::take_errors(bool wait) {
  std::error_code code;
  std::vector<Running> running;
  for (Running& one : running_) {
    if (wait) one.child->wait_gone(kHookExitTimeout);
    const process::Child::Status status = one.child->status();
    if (!status.exit && !wait) {
      running.push_back(std::move(one));
      continue;
    }
    if (!status.exit || status.exit->by_signal || status.exit->number != 0) {
      const std::vector<std::string> output = one.child->last_lines(1);
      errors_.push_back(fmt::format("{}: {}{}", one.child->plan().name,
                                    status.exit ? to_text(*status.exit) : "does not exit",
                                    output.empty() ? "" : ": " + output.front()));
    }
    std::filesystem::remove(one.document, code);
  }
  running_ = std::move(running);
  return std::exchange(errors_, {});
}

}  // namespace cls::orchestration::tournament
