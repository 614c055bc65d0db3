// Holds the agents of a match over UDP before their decisions, for `--step`.
#pragma once

#include <condition_variable>
#include <mutex>

namespace cls::match {

/// One per side. The server must wait for its clients (synch mode).
class TurnGate {
 public:
  explicit TurnGate(bool closed) : open_(!closed) {}

  /// On the side's thread: waits until the match lets one turn pass, unless the gate is open.
  void wait() {
    std::unique_lock lock(mutex_);
    waiting_ = true;
    changed_.wait(lock, [this] { return open_ || pass_; });
    waiting_ = pass_ = false;
  }

  /// On the match's thread. True while the side waits.
  bool has_waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_ && !pass_;
  }
  bool is_closed() const {
    const std::lock_guard lock(mutex_);
    return !open_;
  }
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void let_pass() {
    const std::lock_guard lock(mutex_);
    pass_ = true;
    changed_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool open_;
  bool waiting_ = false;
  bool pass_ = false;
};

}  // namespace cls::match
