// Runs commands of the user on events: of a match, of a tournament.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/process_host.h"

namespace cls::process {

/// How long a command may take by default, and how long the end of a match or tournament waits for
/// all that still run.
inline constexpr std::chrono::seconds kHookLimit{60};

/// A command to run for one event.
struct HookCall {
  std::string name;      ///< in messages: "on_event"
  std::string command;   ///< for /bin/sh -c
  std::string document;  ///< on its standard input
  std::vector<EnvironmentChange> environment;
};

/// Runs commands while matches are played. Those of one name run in sequence, so that a chat shows
/// goals in their order.
class HookRunner {
 public:
  /// Commands run in `working_folder` (empty: that of cls). Documents are stored in `folder` while
  /// their command runs. A command that takes longer than `limit` is ended.
  HookRunner(std::filesystem::path folder, std::filesystem::path working_folder,
             std::chrono::milliseconds limit = kHookLimit)
      : folder_(std::move(folder)), working_folder_(std::move(working_folder)), limit_(limit) {}
  HookRunner(const HookRunner&) = delete;
  HookRunner& operator=(const HookRunner&) = delete;
  /// Kills commands that still run.
  ~HookRunner();

  /// Starts the command, or queues it behind an earlier one of the same name.
  void start(HookCall call);

  /// True when no command runs or waits, and take_errors() has nothing to return.
  bool idle() const { return running_.empty() && waiting_.empty() && errors_.empty(); }

  /// Failures of commands that have exited since the last call, one line each. Ends commands at
  /// their limit and starts those that waited: call it again and again.
  std::vector<std::string> take_errors();

  /// Waits for all commands: `limit` for all of them together, two seconds once `stop_signal` is
  /// not 0 or only processes are left that they have left behind. Ends those that still run, and
  /// names them among the failures.
  std::vector<std::string> finish(const std::atomic<int>& stop_signal);

 private:
  using Clock = std::chrono::steady_clock;

  struct Running {
    std::shared_ptr<Child> child;
    std::filesystem::path document;
    Clock::time_point begin;
    bool overdue = false;
  };

  bool is_busy(const std::string& name) const;
  void start_waiting();
  base::Result<void> start_now(const HookCall& call);
  void end_overdue();
  void report(const Running& one);

  std::filesystem::path folder_;
  std::filesystem::path working_folder_;
  std::chrono::milliseconds limit_;
  std::optional<ProcessHost> host_;
  std::vector<Running> running_;
  std::deque<HookCall> waiting_;
  std::vector<std::string> errors_;
  int started_ = 0;
};

}  // namespace cls::process
