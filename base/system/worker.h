// A thread that does one piece of work at a time for somebody who can stop waiting.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cls::base {

/// One side's thread: all that touches a team happens here, while the match's own thread watches
/// the clock and the signals. Work must not throw.
class Worker {
 public:
  Worker();
  /// Waits for the work at hand, then ends the thread.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Begins `work`; the work before it must be done.
  void start(std::function<void()> work);

  /// True when the work is done, false when it is not yet after `limit`.
  bool wait_for(std::chrono::milliseconds limit);

  /// Ties the thread to these processors (none: no change). Before the first work.
  void run_on(const std::vector<int>& cpus);

  /// CPU time of the thread so far. Call while no work is under way.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  void loop();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> work_;
  bool busy_ = false;
  bool leaving_ = false;
  double cpu_seconds_ = 0.0;
  std::thread thread_;
};

}  // namespace cls::base
