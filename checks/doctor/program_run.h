// Runs short-lived programs, for their version output.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/command_plan.h"
#include "process/process_exit.h"
#include "process/process_host.h"

namespace cls::checks {

struct ProgramRun {
  std::string program;  ///< a name on PATH, or a path
  std::vector<std::string> arguments;
  std::filesystem::path folder;  ///< working directory; empty: inherited
  std::vector<process::EnvironmentChange> environment;
};

struct ProgramOutput {
  std::filesystem::path path;                ///< empty: not found
  std::string absence;                       ///< why it could not be started
  std::optional<process::ProcessExit> exit;  ///< nothing: timeout, terminated
  std::vector<std::string> lines;            ///< first output lines, printable

  bool started() const { return absence.empty(); }
  bool ended_well() const { return exit && !exit->by_signal && exit->number == 0; }
};

/// Runs all in parallel until each has exited, at most for `limit`; then terminates the rest. A
/// nonzero `stop` stops waiting. Returns one output per run, in order.
std::vector<ProgramOutput> run_programs(process::ProcessHost& host,
                                        const std::vector<ProgramRun>& questions,
                                        std::chrono::milliseconds limit,
                                        const std::atomic<int>& stop);

}  // namespace cls::checks
