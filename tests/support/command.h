// Running a program as a user would, and what came of it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace cls::tests {

/// The built binary `cls` of this build.
std::filesystem::path cls_binary();

struct CommandResult {
  int exit_code = -1;  ///< -1: did not end by itself
  int signal = 0;      ///< that ended it, else 0
  std::string out;
  std::string err;
};

/// A program under way, with its output in files of its own. Killed at the end of the scope if it
/// still runs.
class Command {
 public:
  /// `arguments[0]` is the program (looked for on PATH); `environment` lines (NAME=VALUE) are added
  /// to our own. Standard input is empty.
  explicit Command(std::vector<std::string> arguments, std::vector<std::string> environment = {},
                   const std::filesystem::path& working_folder = {});
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  void send_signal(int signal) const;
  pid_t pid() const { return pid_; }

  /// What it has written to stdout so far.
  std::string out() const;
  /// Waits until stdout contains `text`; false after `limit` or when the program ends.
  bool wait_for_output(const std::string& text,
                       std::chrono::seconds limit = std::chrono::seconds(20));

  /// Waits for its end; a program that takes longer than `limit` is killed and has exit_code -1.
  CommandResult finish(std::chrono::seconds limit = std::chrono::seconds(60));

 private:
  bool collect(bool block_not);

  TemporaryFolder folder_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// Runs to the end.
CommandResult run(std::vector<std::string> arguments, std::vector<std::string> environment = {});

}  // namespace cls::tests
