// Starts hooks as child processes with a file as standard input.
#include "orchestration/tournament/run/hook.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "base/io/whole_file.h"

namespace cls::orchestration::tournament {
namespace {

constexpr std::chrono::seconds kHookLimit{60};
constexpr std::chrono::seconds kHookShortLimit{2};
constexpr std::chrono::milliseconds kHookPoll{50};

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

// Adds a failure, if it is one.
void HookRunner::report(const Running& one) {
  const process::Child::Status status = one.child->status();
  const std::string& name = one.child->plan().name;

  if (status.asked_to_end || !status.exit) {
    errors_.push_back(fmt::format("{}: ended, because it still ran", name));
  } else if (status.exit->by_signal || status.exit->number != 0) {
    const std::vector<std::string> output = one.child->last_lines(1);
    errors_.push_back(fmt::format("{}: {}{}", name, to_text(*status.exit),
                                  output.empty() ? "" : ": " + output.front()));
  } else if (!status.gone) {
    errors_.push_back(fmt::format("{}: ended a process that it had left behind", name));
  }
}

std::vector<std::string> HookRunner::take_errors() {
  std::error_code code;
  std::erase_if(running_, [&](const Running& one) {
    if (!one.child->status().gone) return false;
    report(one);
    std::filesystem::remove(one.document, code);
    return true;
  });
  return std::exchange(errors_, {});
}

std::vector<std::string> HookRunner::finish(const std::atomic<int>& stop_signal) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::optional<Clock::time_point> patient_until;  // once nothing worth a minute is left

  std::vector<std::string> errors = take_errors();
  while (!running_.empty()) {
    const Clock::time_point now = Clock::now();
    const bool only_descendants =
        std::all_of(running_.begin(), running_.end(),
                    [](const Running& one) { return one.child->status().exit.has_value(); });
    if (!patient_until && (stop_signal != 0 || only_descendants)) {
      patient_until = now + kHookShortLimit;
    }
    if (now - begin > kHookLimit || (patient_until && now > *patient_until)) break;
    running_.front().child->wait_gone(kHookPoll);
    for (std::string& line : take_errors()) errors.push_back(std::move(line));
  }

  std::error_code code;
  for (const Running& one : running_) {
    report(one);
    one.child->end(std::chrono::seconds(1));
    std::filesystem::remove(one.document, code);
  }
  running_.clear();
  for (std::string& line : take_errors()) errors.push_back(std::move(line));
  return errors;
}

}  // namespace cls::orchestration::tournament
