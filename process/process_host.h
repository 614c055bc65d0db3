// Child processes: start, watch, read output, terminate.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "process/command_plan.h"
#include "process/process_exit.h"

namespace cls::process {

struct ChildRecord;
struct ProcessHostCore;

/// A started program and all its descendants. The destructor terminates them (SIGTERM, 1 s,
/// SIGKILL) without waiting. Thread-safe.
class Child {
 public:
  /// State of a child.
  struct Status {
    int pid = 0;
    std::optional<ProcessExit> exit;  ///< of the program itself, once it has exited
    int living = 0;                   ///< descendants still running at the program's exit
    bool asked_to_end = false;        ///< end() was called before it exited
    bool at_cpu_limit = false;        ///< it or a descendant died of ResourceLimits::cpu_seconds
    bool gone = false;                ///< no process is left, and all output has been read
  };

  Child(std::shared_ptr<ProcessHostCore> core, std::shared_ptr<ChildRecord> record);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  const CommandPlan& plan() const;
  Status status() const;

  /// The last lines of its output, oldest first, printable (see OutputLog::last_lines).
  std::vector<std::string> last_lines(std::size_t count = 50) const;

  /// Why its log is incomplete (disk full); empty: complete.
  std::string log_error() const;

  /// User and system time of the program and all its descendants so far. Takes about 1 ms to ask
  /// the keeper; the last known value if it does not reply within 0.5 s.
  double cpu_seconds() const;
  /// For how long those of them that ran when cpu_seconds() or end() was called were ready to run
  /// and had no processor.
  double delayed_seconds() const;

  /// Requests termination and returns immediately: SIGTERM to the program and all its descendants,
  /// SIGKILL to what is left after `grace`. `gently`: SIGTERM to the program alone, which stops its
  /// own children; what is left gets SIGTERM after its exit.
  void end(std::chrono::milliseconds grace, bool gently = false) const;

  /// Waits until the program has exited, or until no process is left. False: timeout.
  bool wait_exit(std::chrono::milliseconds limit) const;
  bool wait_gone(std::chrono::milliseconds limit) const;

 private:
  std::shared_ptr<ProcessHostCore> core_;
  std::shared_ptr<ChildRecord> record_;
};

/// Starts children through the guard of this process and reads their output on its own thread. The
/// destructor terminates all children and waits for them (3 s at most).
class ProcessHost {
 public:
  /// Called on the host's thread with every line of a child's output, until the Child is destroyed.
  /// Must return quickly and must not call the host or a child.
  using OnLine = std::function<void(std::string_view)>;

  static constexpr std::size_t kLogLimit = 10 << 20;  ///< bytes of one log

  /// An error if Guard::start was not called in main.
  static base::Result<ProcessHost> create(std::size_t log_limit = kLogLimit);
  ProcessHost(ProcessHost&&) = default;
  ProcessHost& operator=(ProcessHost&&) = delete;
  ~ProcessHost();

  /// Starts a program. The error names it and the reason: no such program or folder, no permission,
  /// log cannot be created, no processes left.
  base::Result<std::shared_ptr<Child>> start(const CommandPlan& plan, OnLine on_line = {});

  /// Counts changes of any child's status: a cheap check for polling loops.
  std::uint64_t changes() const;

  /// Terminates all children and waits until no process is left. False if one is still there 2 s
  /// after the grace (stuck in the kernel in spite of SIGKILL).
  bool end_all(std::chrono::milliseconds grace);

 private:
  explicit ProcessHost(std::shared_ptr<ProcessHostCore> core);

  std::shared_ptr<ProcessHostCore> core_;
};

/// How waiting for readiness ended.
enum class Readiness {
  kReady,
  kEnded,        ///< the program exited first
  kTimedOut,     ///< the limit was reached
  kInterrupted,  ///< `stop` became nonzero
};

/// Calls `ready` every 5 ms until it returns true, the program exits (see has_ended), or the limit
/// or a signal is reached.
Readiness wait_until_ready(const Child& child, const std::function<bool()>& ready,
                           std::chrono::milliseconds limit, const std::atomic<int>& stop);

/// True when the program has failed, or has exited without running descendants. A script that
/// starts others and exits with 0 has not ended.
bool has_ended(const Child::Status& status);

}  // namespace cls::process
