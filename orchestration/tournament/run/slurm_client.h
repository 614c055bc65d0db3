// Slurm's own programs, as far as a tournament needs them: scontrol, sbatch, squeue, scancel.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::tournament {

/// What became of a call of sbatch.
struct Submission {
  enum class End {
    kAccepted,
    kTooMuch,      ///< a limit of the site: fewer tasks, or later
    kUnreachable,  ///< no controller answers; nothing was submitted
    kUnknown,      ///< no clear answer came: it may have been submitted or not
    kRefused,      ///< a mistake in the options, no right to submit, ...
  };
  End end = End::kRefused;
  std::string message;  ///< of sbatch, when it was not accepted
};

/// What sbatch's end means. `output` are its lines, stdout and stderr.
Submission submission_from(int exit_code, const std::vector<std::string>& output);

/// A task of a job array as squeue names it: name of the job and array index.
using TaskName = std::pair<std::string, int>;

struct TaskState {
  std::string word;    ///< "PENDING", "RUNNING", "NODE_FAIL", ...
  std::string reason;  ///< of waiting: "Resources", "JobHeldUser", ...
};

/// False when the state is final: Slurm will not run the task (again).
bool may_still_run(const TaskState& state);

/// Calls the programs that PATH finds and waits for each; a program that does not answer within
/// a minute is ended. Jobs are told apart by their names, which must be unique: so what was
/// submitted can be found again by whoever did not live to see the number.
class SlurmClient {
 public:
  /// An error when this process cannot start others.
  static base::Result<SlurmClient> create();

  /// MaxArraySize of the site: array indices are below it. 1001, the default, when it is not told.
  base::Result<int> max_array_size();

  /// `sbatch` with these words.
  Submission submit(const std::vector<std::string>& words);

  /// The tasks of the jobs of these names that Slurm still knows, finished ones too for a while.
  base::Result<std::map<TaskName, TaskState>> tasks(const std::vector<std::string>& names);

  /// Cancels the jobs of this name, or only those of their tasks that wait.
  base::Result<void> cancel(const std::string& name, bool waiting_only);

 private:
  explicit SlurmClient(process::ProcessHost host) : host_(std::move(host)) {}

  struct Answer {
    int exit_code = -1;  ///< -1: it did not end by itself in time
    std::vector<std::string> lines;
  };
  base::Result<Answer> ask(std::vector<std::string> words);

  process::ProcessHost host_;
};

}  // namespace cls::orchestration::tournament
