// The guard: a process beside cls that starts all others and lets none outlive it.
#pragma once

#include <sys/types.h>

#include "base/result.h"
#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

/// The connection to the guard process; at most one in a process.
///
/// The guard is a fork of cls in a session of its own. For each program it forks a keeper
/// (keeper.h), which starts it. When this object goes, or cls dies in whatever way, kill -9
/// included, the keepers see the end of their connections and end everything (SIGTERM, 1 s,
/// SIGKILL); the guard sees to it and then ends too.
class Guard {
 public:
  /// Forks the guard. Call it at the start of main, before any thread or gRPC object exists, and
  /// once only. Also opens /dev/null for those of stdin, stdout and stderr that are closed, lest
  /// later files take their numbers. `argv` of main is used to name the process for ps.
  static base::Result<Guard> start(int argc, char** argv);

  Guard(Guard&& other) noexcept;
  Guard& operator=(Guard&&) = delete;
  /// Ends all that was started and waits until the guard is gone (about 2 s at most).
  ~Guard();

  /// The guard of this process; nullptr when none was started.
  static const Guard* active();

  /// Where requests to start a program go: an encoded plan with two descriptors, the keeper's end
  /// of its connection and the program's output. May be used from several threads.
  int socket() const { return socket_.get(); }
  pid_t pid() const { return pid_; }

 private:
  Guard(UniqueFd socket, pid_t pid);

  UniqueFd socket_;
  pid_t pid_ = 0;
};

}  // namespace cls::orchestration::process
