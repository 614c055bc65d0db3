// Child processes as cls sees them: start, watch, read, end.
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
#include "orchestration/process/command_plan.h"
#include "orchestration/process/process_exit.h"

namespace cls::orchestration::process {

struct ChildRecord;
struct ProcessHostCore;

/// A started program and all that descends from it. The destructor ends it (SIGTERM, 1 s, SIGKILL)
/// without waiting. All functions may be called from any thread.
class Child {
 public:
  /// What is known of a child at one moment.
  struct Status {
    int pid = 0;
    std::optional<ProcessExit> exit;  ///< of the program itself, once it has ended
    int living = 0;                   ///< when `exit` came: descendants that went on
    bool asked_to_end = false;        ///< by end(), before it ended by itself
    bool gone = false;                ///< nothing of it is left, and all its output has been read
  };

  Child(std::shared_ptr<ProcessHostCore> core, std::shared_ptr<ChildRecord> record);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  const CommandPlan& plan() const;
  Status status() const;

  /// The last lines of its output, oldest first, printable (see OutputLog::last_lines).
  std::vector<std::string> last_lines(std::size_t count = 50) const;

  /// Why its log is incomplete (disk full), empty when it is not.
  std::string log_error() const;

  /// User and system time of the program and all its descendants so far. Asks the keeper, which
  /// takes about a millisecond; the last known figure when it does not answer within 0.5 s.
  double cpu_seconds() const;

  /// Asks for the end and returns at once: SIGTERM to the program and all its descendants, SIGKILL
  /// to what is left after `grace`. `gently`: SIGTERM to the program alone, for one that ends its
  /// own children in order; what it leaves gets SIGTERM when it has ended.
  void end(std::chrono::milliseconds grace, bool gently = false) const;

  /// Waits until the program has ended, or until nothing of it is left. False: the time is up.
  bool wait_exit(std::chrono::milliseconds limit) const;
  bool wait_gone(std::chrono::milliseconds limit) const;

 private:
  std::shared_ptr<ProcessHostCore> core_;
  std::shared_ptr<ChildRecord> record_;
};

/// Starts children through the guard of this process and reads their output on a thread of its
/// own. Children that outlive it are ended by its destructor, which waits for them (3 s at most).
class ProcessHost {
 public:
  /// Called on the host's thread with every line of a child's output. Must return quickly and must
  /// not call the host or a child.
  using OnLine = std::function<void(std::string_view)>;

  static constexpr std::size_t kLogLimit = 10 << 20;  ///< bytes of one log

  /// An error when Guard::start was not called in main.
  static base::Result<ProcessHost> create(std::size_t log_limit = kLogLimit);
  ProcessHost(ProcessHost&&) = default;
  ProcessHost& operator=(ProcessHost&&) = delete;
  ~ProcessHost();

  /// Starts a program. The error names it and says why not: no such program, folder or right; the
  /// log cannot be created; no processes left.
  base::Result<std::shared_ptr<Child>> start(const CommandPlan& plan, OnLine on_line = {});

  /// Counts up whenever a child's status changes: a cheap look for loops that have other work.
  std::uint64_t changes() const;

  /// Ends all children and waits until nothing of them is left. False when something is still
  /// there 2 s after the grace (stuck in the kernel, where not even SIGKILL reaches it).
  bool end_all(std::chrono::milliseconds grace);

 private:
  explicit ProcessHost(std::shared_ptr<ProcessHostCore> core);

  std::shared_ptr<ProcessHostCore> core_;
};

/// How waiting for readiness ended.
enum class Readiness {
  kReady,
  kEnded,        ///< the program ended first
  kTimedOut,     ///< the limit was reached
  kInterrupted,  ///< `stop` became nonzero
};

/// Calls `ready` every 5 ms until it is true or there is another reason to stop waiting.
/// A program that returns 0 and leaves living descendants has not ended in this sense: it is a
/// script that starts others and returns.
Readiness wait_until_ready(const Child& child, const std::function<bool()>& ready,
                           std::chrono::milliseconds limit, const std::atomic<int>& stop);

/// True when the program has failed, or has ended and left nothing behind that could do its work.
bool has_ended(const Child::Status& status);

}  // namespace cls::orchestration::process
