// Runs Slurm's programs and parses their text, which is stable over versions; their JSON is not.
#include "tournament/run/slurm_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <optional>

#include "base/text/number_text.h"
#include "base/text/split.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

constexpr std::chrono::seconds kExitTimeout{60};
constexpr int kDefaultMaxArraySize = 1001;

template <std::size_t count>
bool contain_any(const std::vector<std::string>& lines,
                 const std::array<std::string_view, count>& phrases) {
  return std::ranges::any_of(lines, [&](const std::string& line) {
    return std::ranges::any_of(
        phrases, [&](std::string_view phrase) { return line.find(phrase) != std::string::npos; });
  });
}

// Limits of arrays, of users (accounts and QOS), and of the controller.
constexpr std::array<std::string_view, 6> kLimitReached = {
    "Invalid job array specification",    "job submit limit", "MaxSubmitJob",
    "Slurm temporarily unable to accept", "MaxJobCount",      "Resource temporarily unavailable",
};
constexpr std::array<std::string_view, 4> kUnreachable = {
    "Unable to contact slurm controller", "Unable to establish controller machine",
    "Connection refused", "Unable to establish control"};
constexpr std::array<std::string_view, 3> kUnclear = {"Socket timed out", "Zero Bytes were",
                                                      "Unexpected message received"};

constexpr std::array<std::string_view, 10> kFinalStates = {
    "BOOT_FAIL", "CANCELLED",     "COMPLETED", "DEADLINE", "FAILED",
    "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "REVOKED",  "TIMEOUT"};

std::string joined(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "; "));
}

// Parses "name|3|RUNNING|None"; job names hold no bar.
std::optional<std::pair<TaskName, TaskState>> parse_task(std::string_view line) {
  std::vector<std::string_view> fields = base::split(line, '|');
  fields.resize(4);
  const std::optional<int> index = base::parse_int(fields[1]);
  if (!index) return std::nullopt;
  return std::pair(TaskName(fields[0], *index),
                   TaskState{std::string(fields[2]), std::string(fields[3])});
}

}  // namespace

Submission parse_submission(int exit_code, const std::vector<std::string>& output) {
  using Status = Submission::Status;
  if (exit_code == 0) return {Status::kAccepted, ""};
  const std::string message = output.empty() ? "sbatch failed" : joined(output);
  if (contain_any(output, kLimitReached)) return {Status::kLimitReached, message};
  if (exit_code < 0 || contain_any(output, kUnclear)) return {Status::kUnknown, message};
  if (contain_any(output, kUnreachable)) return {Status::kUnreachable, message};
  return {Status::kRefused, message};
}

bool may_still_run(const TaskState& state) {
  return std::ranges::find(kFinalStates, state.state) == kFinalStates.end();
}

std::string clusters_of(const std::vector<std::string>& options) {
  constexpr std::string_view kLong = "--clusters";
  constexpr std::string_view kShort = "-M";
  for (std::size_t i = options.size(); i-- > 0;) {
    const std::string_view option = options[i];
    if ((option == kLong || option == kShort) && i + 1 < options.size()) return options[i + 1];
    if (option.starts_with("--clusters=")) return std::string(option.substr(kLong.size() + 1));
    if (option.starts_with(kShort) && option.size() > kShort.size()) {
      return std::string(option.substr(kShort.size()));
    }
  }

  for (const char* name : {"SBATCH_CLUSTERS", "SLURM_CLUSTERS"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return value;
  }
  return {};
}

Result<SlurmClient> SlurmClient::create(std::string clusters) {
  TRY_INIT(auto host, process::ProcessHost::create());
  return SlurmClient(std::move(host), std::move(clusters));
}

Result<SlurmClient::Output> SlurmClient::run_there(std::vector<std::string> argv) {
  if (!clusters_.empty()) argv.push_back("--clusters=" + clusters_);
  return run(std::move(argv));
}

Result<SlurmClient::Output> SlurmClient::run(std::vector<std::string> argv) {
  process::CommandPlan plan;
  plan.name = argv.front();
  plan.argv = std::move(argv);

  // Shared with the host's thread, which may add a last line after this function returned.
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

  const bool exited = (*child)->wait_gone(kExitTimeout);
  const auto exit = (*child)->status().exit;
  if (!exited) (*child)->end(std::chrono::milliseconds(0));

  Output output;
  if (exited && exit && !exit->by_signal) output.exit_code = exit->number;
  const std::lock_guard lock(lines->mutex);
  output.lines = lines->all;
  if (!exited) output.lines.push_back(plan.name + " does not exit");
  return output;
}

Result<int> SlurmClient::max_array_size() {
  TRY_INIT(const auto output, run({"scontrol", "show", "config"}));
  for (const std::string& line : output.lines) {
    if (!line.starts_with("MaxArraySize")) continue;
    const std::size_t digits = line.find_first_of("0123456789");
    int size = 0;
    if (digits == std::string::npos) break;
    base::parse_int_prefix(std::string_view(line).substr(digits), size);
    if (size == 0) return Error{"this Slurm accepts no job arrays (MaxArraySize = 0)"};
    return size;
  }
  return kDefaultMaxArraySize;
}

Submission SlurmClient::submit(const std::vector<std::string>& arguments) {
  std::vector<std::string> argv = {"sbatch"};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  const auto output = run(std::move(argv));
  if (!output) return {Submission::Status::kRefused, output.error().message};
  return parse_submission(output->exit_code, output->lines);
}

Result<std::map<TaskName, TaskState>> SlurmClient::tasks(const std::vector<std::string>& names) {
  TRY_INIT(const auto output,
           run_there({"squeue", "--noheader", "--array", "--states=all",
                      fmt::format("--name={}", fmt::join(names, ",")), "--format=%j|%K|%T|%r"}));
  if (output.exit_code != 0) return Error{joined(output.lines)};
  std::map<TaskName, TaskState> tasks;
  for (const std::string& line : output.lines) {
    if (auto task = parse_task(line)) tasks.insert(*std::move(task));
  }
  return tasks;
}

Result<void> SlurmClient::cancel(const std::string& name, bool pending_only) {
  std::vector<std::string> argv = {"scancel", "--name=" + name};
  if (pending_only) argv.emplace_back("--state=PENDING");
  TRY_INIT(const auto output, run_there(std::move(argv)));
  if (output.exit_code != 0) return Error{joined(output.lines)};
  return {};
}

}  // namespace cls::tournament
