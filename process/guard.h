// The guard: a process next to cls that starts all other processes and terminates those that would
// outlive it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "base/result.h"
#include "base/system/unique_fd.h"

namespace cls::process {

/// The connection to the guard process; at most one in a process.
///
/// The guard is a fork of cls in a session of its own. For each program it forks a keeper
/// (keeper.h), which starts it. When this object is destroyed or cls exits in any way, kill -9
/// included, the keepers see their connections close and terminate everything (SIGTERM, 1 s,
/// SIGKILL). The guard kills orphans that are left, deletes temporary folders, and exits.
class Guard {
 public:
  /// Forks the guard. Call once, at the start of main, before any thread or gRPC object exists.
  /// Standard descriptors must be open (base::protect_standard_streams). Overwrites `argv` of main
  /// to name the process for ps.
  static base::Result<Guard> start(int argc, char** argv);

  Guard(Guard&& other) noexcept;
  Guard& operator=(Guard&&) = delete;
  /// Terminates all started processes and waits until the guard has exited (about 2 s at most).
  ~Guard();

  /// The guard of this process; nullptr when none was started.
  static const Guard* active();
  /// Why start() failed; empty: it did not, or was not called.
  static const std::string& start_error();

  /// For requests to start a program: an encoded plan with two descriptors, the keeper's end of its
  /// connection and the program's output. Thread-safe.
  int socket() const { return socket_.get(); }
  /// The guard deletes this folder when it exits, after the last process. Thread-safe, as forget().
  void delete_at_exit(const std::filesystem::path& folder) const;
  void forget(const std::filesystem::path& folder) const;
  pid_t pid() const { return pid_; }

 private:
  Guard(base::UniqueFd socket, pid_t pid);

  base::UniqueFd socket_;
  pid_t pid_ = 0;
};

}  // namespace cls::process
