// Slurm's programs as scripts on a PATH of the test's own: a queue in a file, no cluster.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {

/// While it lives, PATH begins with sbatch, squeue, scancel, scontrol and sacct that work on a
/// list of tasks. Nothing is ever played: the test says what becomes of the tasks.
class FakeSlurm {
 public:
  FakeSlurm();
  ~FakeSlurm();
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  void set_max_array_size(int size);
  /// sbatch refuses what would make more tasks than this wait or run.
  void set_max_tasks(int count);
  /// The next calls of sbatch fail with these words, one each.
  void refuse(const std::vector<std::string>& messages);
  /// Nobody reaches the controller.
  void set_down(bool down);

  /// What squeue says of a task; "" makes it forget the task.
  void set_state(const std::string& job, int task, const std::string& state,
                 const std::string& reason = "None");
  /// Lines "name|task|state|reason".
  std::vector<std::string> queue() const;
  /// Tasks of this state.
  int count(const std::string& state) const;

  /// Calls so far of a program, with their words.
  std::vector<std::string> calls(const std::string& program) const;

 private:
  void write_program(const std::string& name, const std::string& text);
  void write(const std::string& name, const std::string& text) const;
  std::vector<std::string> lines(const std::string& name) const;

  tests::TemporaryFolder folder_;
  std::string path_before_;
};

}  // namespace cls::orchestration::tournament
