// Names, script and record of a Slurm batch.
#include "tournament/run/slurm_batch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "process/command_plan.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Json;
using base::Result;

constexpr std::size_t kMaxFolderNameLength = 24;

fs::path file_of(const SlurmBatch& batch, std::string_view ending) {
  return fs::path(kSlurmFolder) / fmt::format("{:06}{}", batch.number, ending);
}

// Letters and digits of the folder's name, to recognize the job in squeue.
std::string short_name(const fs::path& folder) {
  fs::path whole = fs::absolute(folder).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  std::string name = whole.filename().string();
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return name.substr(0, kMaxFolderNameLength);
}

// The list is in positional parameters, because the controller copies only the script.
std::string script_of(const fs::path& folder, const SlurmBatch& batch, const fs::path& program) {
  std::string list;
  for (const SlurmBatch::Task& task : batch.tasks) {
    list += fmt::format(" {} {}", task.index, task.attempt);
  }
  return fmt::format(
      "#!/bin/sh\n"
      "# A job array of cls tournament: task K plays the K-th pair of match and attempt.\n"
      "set --{}\n"
      "shift $((2 * SLURM_ARRAY_TASK_ID))\n"
      "exec {} tournament work {} --index \"$1\" --attempt \"$2\" --schedule {}\n",
      list, process::shell_quoted(program.string()), process::shell_quoted(folder.string()),
      process::shell_quoted((folder / file_of(batch, ".jsonl")).string()));
}

// Escapes percent signs, which sbatch expands.
std::string escape_percents(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '%' ? 2 : 1, c);
  return doubled;
}

std::optional<SlurmBatch> read_batch(const fs::path& file) {
  const auto text = base::read_file(file);
  try {
    const Json json = Json::parse(text.value_or(""));
    SlurmBatch batch;
    batch.number = json.at("number").get<int>();
    batch.name = json.at("name").get<std::string>();
    for (const Json& task : json.at("tasks")) {
      batch.tasks.push_back({task.at(0).get<int>(), task.at(1).get<int>()});
    }
    return batch;
  } catch (const base::Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

SlurmBatch make_batch(int number, const fs::path& folder, std::span<const Assignment> assignments) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  SlurmBatch batch;
  batch.number = number;
  batch.name = fmt::format("cls-{}-{}-{:x}-{:x}", short_name(folder), number, ::getpid(), now);
  for (const Assignment& one : assignments) {
    batch.tasks.push_back({one.fixture.index, one.number});
  }
  return batch;
}

Result<void> write_batch(const fs::path& folder, const SlurmBatch& batch,
                         std::span<const Assignment> assignments, const fs::path& program) {
  std::string schedule;
  Json tasks = Json::array();
  for (const Assignment& one : assignments) {
    schedule += format_fixture(one.fixture);
    tasks.push_back({one.fixture.index, one.number});
  }

  const Json record = {{"schema", "cls.slurm/1"},
                       {"number", batch.number},
                       {"name", batch.name},
                       {"tasks", std::move(tasks)}};

  std::error_code code;
  fs::create_directories(folder / kSlurmFolder, code);
  const std::array<std::pair<const char*, std::string>, 3> files = {
      {{".jsonl", schedule},
       {".sh", script_of(folder, batch, program)},
       {".json", base::json_line(record)}}};
  for (const auto& [ending, text] : files) {
    TRY(base::write_file(folder / file_of(batch, ending), text));
  }
  return {};
}

std::vector<std::string> sbatch_arguments(const fs::path& folder, const SlurmBatch& batch,
                                          const std::vector<std::string>& options, int parallel) {
  std::vector<std::string> arguments = {"--requeue", "--open-mode=append"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(
      arguments.end(),
      {"--parsable", "--job-name=" + batch.name,
       fmt::format("--array=0-{}{}", batch.tasks.size() - 1,
                   parallel > 0 ? fmt::format("%{}", parallel) : ""),
       "--chdir=" + folder.string(),
       fmt::format("--output={}-%a.out", escape_percents((folder / file_of(batch, "")).string())),
       (folder / file_of(batch, ".sh")).string()});
  return arguments;
}

std::vector<SlurmBatch> read_batches(const fs::path& folder) {
  std::vector<SlurmBatch> batches;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kSlurmFolder, code)) {
    if (entry.path().extension() != ".json") continue;
    if (auto batch = read_batch(entry.path())) batches.push_back(*std::move(batch));
  }
  std::sort(batches.begin(), batches.end(),
            [](const SlurmBatch& a, const SlurmBatch& b) { return a.number < b.number; });
  return batches;
}

int next_batch_number(const fs::path& folder) {
  int last = 0;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kSlurmFolder, code)) {
    const std::string name = entry.path().filename().string();
    int number = 0;
    base::parse_int_prefix(name, number);
    last = std::max(last, number);
  }
  return last + 1;
}

void remove_batch(const fs::path& folder, const SlurmBatch& batch) {
  std::error_code code;
  for (const char* ending : {".json", ".sh", ".jsonl"}) {
    fs::remove(folder / file_of(batch, ending), code);
  }
}

fs::path task_log(const SlurmBatch& batch, int task) {
  return fs::path(kSlurmFolder) / fmt::format("{:06}-{}.out", batch.number, task);
}

}  // namespace cls::tournament
