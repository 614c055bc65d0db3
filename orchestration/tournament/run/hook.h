// Commands of the user that are told what happened.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/process/process_host.h"

namespace cls::orchestration::tournament {

/// Runs the user's commands beside the matches, each with a document on its standard input.
class HookRunner {
 public:
  /// Documents lie in `folder` while a command runs.
  explicit HookRunner(std::filesystem::path folder) : folder_(std::move(folder)) {}
  HookRunner(const HookRunner&) = delete;
  HookRunner& operator=(const HookRunner&) = delete;
  /// Ends what still runs.
  ~HookRunner();

  /// Starts `command` with /bin/sh -c.
  void start(const std::string& name, const std::string& command, const std::string& document);

  /// What went wrong with commands that have ended since the last call, one line each. `wait`:
  /// first waits for all of them, a minute at most.
  std::vector<std::string> take_complaints(bool wait = false);

 private:
  struct Running {
    std::shared_ptr<process::Child> child;
    std::filesystem::path document;
  };

  std::filesystem::path folder_;
  std::optional<process::ProcessHost> host_;
  std::vector<Running> running_;
  std::vector<std::string> complaints_;
  int started_ = 0;
};

}  // namespace cls::orchestration::tournament
