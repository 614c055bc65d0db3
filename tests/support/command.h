// Runs a program as a user would and returns its result.
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
  int exit_code = -1;  ///< -1: killed
  int signal = 0;      ///< signal that terminated it, otherwise 0
  std::string out;
  std::string err;
};

/// A running program with its output in temporary files. The destructor kills it if it still runs.
class Command {
 public:
  /// `arguments[0]` is the program (searched on PATH); `environment` lines (NAME=VALUE) are added
  /// to the inherited ones. Standard input is empty.
  explicit Command(std::vector<std::string> arguments, std::vector<std::string> environment = {},
                   const std::filesystem::path& working_folder = {});
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  void send_signal(int signal) const;
  pid_t pid() const { return pid_; }

  /// Its stdout so far.
  std::string out() const;
  /// Waits until stdout contains `text`; false after `limit` or when the program exits.
  bool wait_for_output(const std::string& text,
                       std::chrono::seconds limit = std::chrono::seconds(20));
  /// Waits as wait_for_output(), but for text on stderr.
  bool wait_for_errors(const std::string& text,
                       std::chrono::seconds limit = std::chrono::seconds(20));

  /// Waits for its exit; kills it after `limit` (exit_code -1).
  CommandResult finish(std::chrono::seconds limit = std::chrono::seconds(60));

 private:
  bool collect(bool block_not);
  std::string printed(const char* stream) const;
  bool wait_for(const char* stream, const std::string& text, std::chrono::seconds limit);

  TemporaryFolder folder_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// All words, `more` last.
inline std::vector<std::string> joined(std::vector<std::string> words,
                                       const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Runs to the end.
CommandResult run(std::vector<std::string> arguments, std::vector<std::string> environment = {});

}  // namespace cls::tests
