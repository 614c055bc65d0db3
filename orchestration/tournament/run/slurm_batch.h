// A job array of matches, and what of it lies in the tournament's folder while it is under way.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/run/match_executor.h"

namespace cls::orchestration::tournament {

/// Task i of the array plays tasks[i].
struct SlurmBatch {
  int number = 0;    ///< of this tournament, from 1
  std::string name;  ///< of the job; no other job has it
  struct Task {
    int index = 0;
    int attempt = 1;
  };
  std::vector<Task> tasks;
};

/// A batch with a name of its own.
SlurmBatch make_batch(int number, const std::filesystem::path& folder,
                      std::span<const Assignment> assignments);

/// slurm/000001.json, .sh and .jsonl: the record by which a later run knows of the batch, the job's
/// script, and the schedule of its matches. To be written before sbatch is called.
base::Result<void> write_batch(const std::filesystem::path& folder, const SlurmBatch& batch,
                               std::span<const Assignment> assignments,
                               const std::filesystem::path& program);

/// Words for sbatch that submit a batch that was written; `parallel` tasks at once (0: any number).
std::vector<std::string> submit_words(const std::filesystem::path& folder, const SlurmBatch& batch,
                                      const std::vector<std::string>& options, int parallel);

/// The batches that were written and not removed yet, by number.
std::vector<SlurmBatch> read_batches(const std::filesystem::path& folder);

/// A number that no file of an earlier batch bears.
int next_batch_number(const std::filesystem::path& folder);

/// Removes what write_batch wrote; logs of tasks stay.
void remove_batch(const std::filesystem::path& folder, const SlurmBatch& batch);

/// Output of a task: "slurm/000001-3.out".
std::filesystem::path task_log(const SlurmBatch& batch, int task);

}  // namespace cls::orchestration::tournament
