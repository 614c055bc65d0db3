// Starts hooks as child processes with a file as standard input.
#include "process/hook_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/io/whole_file.h"

namespace cls::process {
namespace {

constexpr std::chrono::seconds kHookShortLimit{2};
constexpr std::chrono::milliseconds kHookPoll{50};
constexpr std::chrono::seconds kHookGrace{1};

}  // namespace

HookRunner::~HookRunner() {
  std::error_code code;
  for (const Running& one : running_) {
    one.child->end(std::chrono::milliseconds(0));
    std::filesystem::remove(one.document, code);
  }
}

void HookRunner::start(HookCall call) {
  waiting_.push_back(std::move(call));
  start_waiting();
}

// Processes that a command has left behind do not hold up the next one.
bool HookRunner::is_busy(const std::string& name) const {
  return std::ranges::any_of(running_, [&name](const Running& one) {
    return one.child->plan().name == name && !one.child->status().exit;
  });
}

void HookRunner::start_waiting() {
  std::erase_if(waiting_, [this](const HookCall& call) {
    if (is_busy(call.name)) return false;
    if (auto started = start_now(call); !started) errors_.push_back(started.error().message);
    return true;
  });
}

base::Result<void> HookRunner::start_now(const HookCall& call) {
  const std::filesystem::path file =
      std::filesystem::absolute(folder_) / fmt::format(".hook-{}.json", ++started_);
  TRY(base::write_file(file, call.document));

  if (!host_) {
    TRY_INIT(auto created, ProcessHost::create());
    host_.emplace(std::move(created));
  }

  const std::string line = fmt::format("exec <{}\n{}", shell_quoted(file.string()), call.command);
  CommandPlan plan = shell_command(call.name, line);
  plan.folder = working_folder_;
  plan.environment = call.environment;
  TRY_INIT(auto child, host_->start(plan));
  running_.push_back({std::move(child), file, Clock::now()});
  return {};
}

void HookRunner::end_overdue() {
  for (Running& one : running_) {
    if (one.overdue || Clock::now() - one.begin < limit_) continue;
    one.overdue = true;
    one.child->end(kHookGrace);
  }
}

// Adds a failure, if it is one.
void HookRunner::report(const Running& one) {
  const Child::Status status = one.child->status();
  const std::string& name = one.child->plan().name;

  if (status.asked_to_end || !status.exit) {
    errors_.push_back(fmt::format("{}: ended, because it still ran", name));
  } else if (status.exit->by_signal || status.exit->number != 0) {
    const std::vector<std::string> output = one.child->last_lines(1);
    errors_.push_back(fmt::format("{}: {}{}", name, to_text(*status.exit),
                                  output.empty() ? "" : ": " + output.front()));
  } else if (!status.gone || one.overdue) {
    errors_.push_back(fmt::format("{}: ended a process that it had left behind", name));
  }
}

std::vector<std::string> HookRunner::take_errors() {
  end_overdue();
  std::error_code code;
  std::erase_if(running_, [&](const Running& one) {
    if (!one.child->status().gone) return false;
    report(one);
    std::filesystem::remove(one.document, code);
    return true;
  });

  start_waiting();
  return std::exchange(errors_, {});
}

std::vector<std::string> HookRunner::finish(const std::atomic<int>& stop_signal) {
  const Clock::time_point begin = Clock::now();
  std::optional<Clock::time_point> patient_until;  // once nothing worth the limit is left

  std::vector<std::string> errors = take_errors();
  while (!running_.empty()) {
    const Clock::time_point now = Clock::now();
    const bool only_descendants =
        waiting_.empty() && std::ranges::all_of(running_, [](const Running& one) {
          return one.child->status().exit.has_value();
        });
    if (!patient_until && (stop_signal != 0 || only_descendants)) {
      patient_until = now + kHookShortLimit;
    }
    if (now - begin > limit_ || (patient_until && now > *patient_until)) break;

    running_.front().child->wait_gone(kHookPoll);
    for (std::string& line : take_errors()) errors.push_back(std::move(line));
  }

  std::error_code code;
  for (const Running& one : running_) {
    report(one);
    one.child->end(kHookGrace);
    std::filesystem::remove(one.document, code);
  }

  running_.clear();
  if (!waiting_.empty()) {
    errors_.push_back(
        fmt::format("{}: not run for {} later events", waiting_.front().name, waiting_.size()));
    waiting_.clear();
  }
  for (std::string& line : take_errors()) errors.push_back(std::move(line));
  return errors;
}

}  // namespace cls::process
