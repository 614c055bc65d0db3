// Asking programs of this machine who they are: started, listened to for a moment, ended.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/process/command_plan.h"
#include "orchestration/process/process_exit.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::checks {

struct ProgramQuestion {
  std::string program;  ///< a name to look for on PATH, or a path
  std::vector<std::string> arguments;
  std::filesystem::path folder;  ///< working directory; empty: ours
  std::vector<process::EnvironmentChange> environment;
};

struct ProgramAnswer {
  std::filesystem::path path;                ///< empty: there is no such program
  std::string absence;                       ///< why it could not be started
  std::optional<process::ProcessExit> exit;  ///< none: it did not end in time, and was ended
  std::vector<std::string> lines;            ///< the first that it printed, safe to show

  bool started() const { return absence.empty(); }
  bool ended_well() const { return exit && !exit->by_signal && exit->number == 0; }
};

/// Asks all at once and waits until each has ended, `limit` at most; nothing of them is left then.
/// `stop` nonzero ends the waiting. One answer for each question, in their order.
std::vector<ProgramAnswer> ask_programs(process::ProcessHost& host,
                                        const std::vector<ProgramQuestion>& questions,
                                        std::chrono::milliseconds limit,
                                        const std::atomic<int>& stop);

}  // namespace cls::orchestration::checks
