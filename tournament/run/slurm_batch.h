// A Slurm job array of matches, and its files in the tournament's folder.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "tournament/config/config.h"
#include "tournament/run/match_executor.h"

namespace cls::tournament {

/// Task i of the array plays tasks[i].
struct SlurmBatch {
  int number = 0;    ///< of this tournament, from 1
  std::string name;  ///< of the job; unique
  struct Task {
    int index = 0;
    int attempt = 1;
  };
  std::vector<Task> tasks;
};

/// A batch with a unique name.
SlurmBatch make_batch(int number, const std::filesystem::path& folder,
                      std::span<const Assignment> assignments);

/// Writes slurm/000001.json, .sh and .jsonl: the record by which a later run finds the batch, the
/// job's script, and the schedule of its matches. Call it before sbatch.
base::Result<void> write_batch(const std::filesystem::path& folder, const SlurmBatch& batch,
                               std::span<const Assignment> assignments,
                               const std::filesystem::path& program);

/// Arguments for sbatch that submit a written batch; at most `parallel` tasks run concurrently (0:
/// no limit).
std::vector<std::string> sbatch_arguments(const std::filesystem::path& folder,
                                          const SlurmBatch& batch,
                                          const std::vector<std::string>& options, int parallel);

/// The batches that were written and not removed, by number.
std::vector<SlurmBatch> read_batches(const std::filesystem::path& folder);

/// A number above those of all earlier batches.
int next_batch_number(const std::filesystem::path& folder);

/// Removes the files of write_batch; logs of tasks stay.
void remove_batch(const std::filesystem::path& folder, const SlurmBatch& batch);

/// Log of a task: "slurm/000001-3.out".
std::filesystem::path task_log(const SlurmBatch& batch, int task);

}  // namespace cls::tournament
