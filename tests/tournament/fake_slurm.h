// Fake Slurm programs: scripts on the PATH of the test, with a queue in a file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace cls::tournament {

/// While it lives, PATH starts with sbatch, squeue, scancel, scontrol and sacct that work on a
/// list of tasks. The tasks play nothing: the test sets their states.
class FakeSlurm {
 public:
  FakeSlurm();
  ~FakeSlurm();
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  void set_max_array_size(int size);
  /// Maximum of pending and running tasks; sbatch rejects further ones.
  void set_max_tasks(int count);
  /// The next calls of sbatch fail with these messages, one each.
  void refuse(const std::vector<std::string>& messages);
  /// Makes the controller unreachable.
  void set_down(bool down);

  /// Sets the state of a task in squeue; "" removes the task.
  void set_state(const std::string& job, int task, const std::string& state,
                 const std::string& reason = "None");
  /// Lines "name|task|state|reason".
  std::vector<std::string> queue() const;
  /// Number of tasks in this state.
  int count(const std::string& state) const;

  /// Calls of a program so far, with their arguments.
  std::vector<std::string> calls(const std::string& program) const;

 private:
  void write_program(const std::string& name, const std::string& text);
  void write(const std::string& name, const std::string& text) const;
  std::vector<std::string> lines(const std::string& name) const;

  tests::TemporaryFolder folder_;
  std::string path_before_;
};

}  // namespace cls::tournament
