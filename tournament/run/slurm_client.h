// Client of Slurm through its programs scontrol, sbatch, squeue and scancel.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "process/process_host.h"

namespace cls::tournament {

/// The result of a call of sbatch.
struct Submission {
  enum class Status {
    kAccepted,
    kLimitReached,  ///< a limit of the site: submit fewer tasks, or later
    kUnreachable,   ///< the controller does not reply; nothing was submitted
    kUnknown,       ///< no clear reply: the job may have been submitted
    kRefused,       ///< invalid options, missing permission, ...
  };
  Status status = Status::kRefused;
  std::string message;  ///< of sbatch, unless accepted
};

/// Classifies a call of sbatch. `output` are its lines on stdout and stderr.
Submission parse_submission(int exit_code, const std::vector<std::string>& output);

/// A task of a job array in squeue: job name and array index.
using TaskName = std::pair<std::string, int>;

struct TaskState {
  std::string state;   ///< "PENDING", "RUNNING", "NODE_FAIL", ...
  std::string reason;  ///< why it is pending: "Resources", "JobHeldUser", ...
};

/// The clusters to which sbatch submits with these options: those of `--clusters` and `-M`, else of
/// SBATCH_CLUSTERS or SLURM_CLUSTERS; empty: that of this host.
std::string clusters_of(const std::vector<std::string>& options);

/// False when the state is final: Slurm will not run the task (again).
bool may_still_run(const TaskState& state);

/// Runs the programs that PATH finds and waits for each; kills a program that does not exit within
/// a minute. Jobs are identified by their names, which must be unique: so a later run finds a job
/// even if the run that submitted it was killed before it read the job number.
class SlurmClient {
 public:
  /// `clusters`: where the jobs are, see clusters_of(); empty: the cluster of this host.
  static base::Result<SlurmClient> create(std::string clusters = "");

  /// MaxArraySize of the site: array indices are below it. Slurm's default, 1001, if not reported.
  base::Result<int> max_array_size();

  /// Runs `sbatch` with these arguments.
  Submission submit(const std::vector<std::string>& arguments);

  /// The tasks of the jobs of these names that squeue lists; finished ones stay there for a while.
  base::Result<std::map<TaskName, TaskState>> tasks(const std::vector<std::string>& names);

  /// Cancels the jobs of this name, or only their pending tasks.
  base::Result<void> cancel(const std::string& name, bool pending_only);

 private:
  SlurmClient(process::ProcessHost host, std::string clusters)
      : host_(std::move(host)), clusters_(std::move(clusters)) {}

  struct Output {
    int exit_code = -1;  ///< -1: killed by a signal or at the timeout
    std::vector<std::string> lines;
  };
  base::Result<Output> run(std::vector<std::string> argv);
  /// Runs a program that asks one cluster unless it is told which ones.
  base::Result<Output> run_there(std::vector<std::string> argv);

  process::ProcessHost host_;
  std::string clusters_;
};

}  // namespace cls::tournament
