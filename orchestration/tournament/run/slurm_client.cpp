// Starting them, reading what they say. Their text is stable over versions; their JSON is not.
#include "orchestration/tournament/run/slurm_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <mutex>
#include <optional>

namespace cls::orchestration::tournament {
namespace {

using base::Error;
using base::Result;

constexpr std::chrono::seconds kAnswerLimit{60};
constexpr int kDefaultMaxArraySize = 1001;

bool says(const std::vector<std::string>& lines, std::string_view words) {
  return std::any_of(lines.begin(), lines.end(), [words](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

template <std::size_t count>
bool says_any(const std::vector<std::string>& lines,
              const std::array<std::string_view, count>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](std::string_view words) { return says(lines, words); });
}

// Limits of arrays, of users (in accounts and qualities of service), of the controller.
constexpr std::array<std::string_view, 6> kTooMuch = {
    "Invalid job array specification",    "job submit limit", "MaxSubmitJob",
    "Slurm temporarily unable to accept", "MaxJobCount",      "Resource temporarily unavailable",
};
constexpr std::array<std::string_view, 4> kUnreachable = {
    "Unable to contact slurm controller", "Unable to establish controller machine",
    "Connection refused", "Unable to establish control"};
constexpr std::array<std::string_view, 3> kUnclear = {"Socket timed out", "Zero Bytes were",
                                                      "Unexpected message received"};

constexpr std::array<std::string_view, 10> kFinal = {
    "BOOT_FAIL", "CANCELLED",     "COMPLETED", "DEADLINE", "FAILED",
    "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "REVOKED",  "TIMEOUT"};

std::string joined(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "; "));
}

// "name|3|RUNNING|None"; names have no bar in them.
std::optional<std::pair<TaskName, TaskState>> task_in(std::string_view line) {
  std::array<std::string_view, 4> fields;
  for (std::string_view& field : fields) {
    const std::size_t bar = line.find('|');
    field = line.substr(0, bar);
    line.remove_prefix(bar == std::string_view::npos ? line.size() : bar + 1);
  }
  int index = 0;
  const char* end = fields[1].data() + fields[1].size();
  if (fields[1].empty() || std::from_chars(fields[1].data(), end, index).ptr != end) {
    return std::nullopt;
  }
  return std::pair(TaskName(fields[0], index),
                   TaskState{std::string(fields[2]), std::string(fields[3])});
}

}  // namespace

Submission submission_from(int exit_code, const std::vector<std::string>& output) {
  using End = Submission::End;
  if (exit_code == 0) return {End::kAccepted, ""};
  const std::string message = output.empty() ? "sbatch failed" : joined(output);
  if (says_any(output, kTooMuch)) return {End::kTooMuch, message};
  if (exit_code < 0 || says_any(output, kUnclear)) return {End::kUnknown, message};
  if (says_any(output, kUnreachable)) return {End::kUnreachable, message};
  return {End::kRefused, message};
}

bool may_still_run(const TaskState& state) {
  return std::find(kFinal.begin(), kFinal.end(), state.word) == kFinal.end();
}

Result<SlurmClient> SlurmClient::create() {
  auto host = process::ProcessHost::create();
  if (!host) return host.error();
  return SlurmClient(*std::move(host));
}

Result<SlurmClient::Answer> SlurmClient::ask(std::vector<std::string> words) {
  process::CommandPlan plan;
  plan.name = words.front();
  plan.argv = std::move(words);
  // Shared with the host's thread, which may bring a last line when nobody waits any more.
  struct Lines {
    std::mutex mutex;
    std::vector<std::string> all;
  };
  const auto lines = std::make_shared<Lines>();
  const auto child = host_.start(plan, [lines](std::string_view line) {
    const std::lock_guard lock(lines->mutex);
    lines->all.emplace_back(line);
  });
  if (!child) return child.error();
  const bool answered = (*child)->wait_gone(kAnswerLimit);
  const auto exit = (*child)->status().exit;
  if (!answered) (*child)->end(std::chrono::milliseconds(0));
  Answer answer;
  if (answered && exit && !exit->by_signal) answer.exit_code = exit->number;
  const std::lock_guard lock(lines->mutex);
  answer.lines = lines->all;
  if (!answered) answer.lines.push_back(plan.name + " does not answer");
  return answer;
}

Result<int> SlurmClient::max_array_size() {
  const auto answer = ask({"scontrol", "show", "config"});
  if (!answer) return answer.error();
  for (const std::string& line : answer->lines) {
    if (!line.starts_with("MaxArraySize")) continue;
    const std::size_t digits = line.find_first_of("0123456789");
    int size = 0;
    if (digits == std::string::npos) break;
    std::from_chars(line.data() + digits, line.data() + line.size(), size);
    if (size == 0) return Error{"this Slurm takes no job arrays (MaxArraySize = 0)"};
    return size;
  }
  return kDefaultMaxArraySize;
}

Submission SlurmClient::submit(const std::vector<std::string>& words) {
  std::vector<std::string> argv = {"sbatch"};
  argv.insert(argv.end(), words.begin(), words.end());
  const auto answer = ask(std::move(argv));
  if (!answer) return {Submission::End::kRefused, answer.error().message};
  return submission_from(answer->exit_code, answer->lines);
}

Result<std::map<TaskName, TaskState>> SlurmClient::tasks(const std::vector<std::string>& names) {
  const auto answer =
      ask({"squeue", "--noheader", "--array", "--states=all",
           fmt::format("--name={}", fmt::join(names, ",")), "--format=%j|%K|%T|%r"});
  if (!answer) return answer.error();
  if (answer->exit_code != 0) return Error{joined(answer->lines)};
  std::map<TaskName, TaskState> tasks;
  for (const std::string& line : answer->lines) {
    if (auto task = task_in(line)) tasks.insert(*std::move(task));
  }
  return tasks;
}

Result<void> SlurmClient::cancel(const std::string& name, bool waiting_only) {
  std::vector<std::string> argv = {"scancel", "--name=" + name};
  if (waiting_only) argv.emplace_back("--state=PENDING");
  const auto answer = ask(std::move(argv));
  if (!answer) return answer.error();
  if (answer->exit_code != 0) return Error{joined(answer->lines)};
  return {};
}

}  // namespace cls::orchestration::tournament
