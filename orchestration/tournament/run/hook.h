// Runs the commands on_match_finish and on_finish.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/process/process_host.h"

namespace cls::orchestration::tournament {

/// Runs commands concurrently with the matches, each with a document on its standard input.
class HookRunner {
 public:
  /// Commands run in `working_folder` (empty: that of cls). Documents are stored in `folder` while
  /// their command runs.
  HookRunner(std::filesystem::path folder, std::filesystem::path working_folder)
      : folder_(std::move(folder)), working_folder_(std::move(working_folder)) {}
  HookRunner(const HookRunner&) = delete;
  HookRunner& operator=(const HookRunner&) = delete;
  /// Kills commands that still run.
  ~HookRunner();

  /// Starts `command` with /bin/sh -c.
  void start(const std::string& name, const std::string& command, const std::string& document);

  /// Failures of commands that have exited since the last call, one line each.
  std::vector<std::string> take_errors();

  /// Waits for all commands: a minute for all of them together, two seconds once `stop_signal` is
  /// not 0 or only processes are left that they have left behind. Ends those that still run, and
  /// names them among the failures.
  std::vector<std::string> finish(const std::atomic<int>& stop_signal);

 private:
  struct Running {
    std::shared_ptr<process::Child> child;
    std::filesystem::path document;
  };

  void report(const Running& one);

  std::filesystem::path folder_;
  std::filesystem::path working_folder_;
  std::optional<process::ProcessHost> host_;
  std::vector<Running> running_;
  std::vector<std::string> errors_;
  int started_ = 0;
};

}  // namespace cls::orchestration::tournament
