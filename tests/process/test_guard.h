// Shared by the process tests: the guard of the test program, and the fakes.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "process/process_host.h"

namespace cls::process {

/// A plan that runs the fake process with these actions (tests/fakes/fake_process.cpp).
CommandPlan fake(std::vector<std::string> actions);

/// A host whose children carry `mark` in their environment (tests/support/marked_processes.h).
class MarkedHost {
 public:
  MarkedHost();

  ProcessHost host;
  const std::string mark;

  /// Starts a plan with the mark; throws when it cannot be started.
  std::shared_ptr<Child> start(CommandPlan plan, ProcessHost::OnLine on_line = {});
  std::shared_ptr<Child> start_fake(std::vector<std::string> actions);

  /// No process that was started here is running.
  bool nothing_left(std::chrono::milliseconds limit = std::chrono::milliseconds(0)) const;
};

/// Waits until `line` is among the child's last lines.
bool saw_line(const Child& child, const std::string& line);

}  // namespace cls::process
