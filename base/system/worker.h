// A worker thread whose owner waits for one task at a time, with a timeout.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cls::base {

/// Runs all code of one side of a match, while the thread of the match watches clock and signals.
/// Work must not throw.
class Worker {
 public:
  Worker();
  /// Waits for the running work, then joins the thread.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Starts `work`; the previous work must be done.
  void start(std::function<void()> work);

  /// Does `work` on the calling thread, without the two thread switches of start() and wait_for().
  /// The previous work must be done.
  void run(const std::function<void()>& work);

  /// Waits until the work is done.
  void wait();

  /// Waits until the work is done; false after `timeout`.
  bool wait_for(std::chrono::milliseconds timeout);

  /// Restricts the thread to these processors (none: no change). Call before the first start().
  void set_affinity(const std::vector<int>& cpus);

  /// CPU time of all work so far. Call only while no work is running.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  void loop();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> work_;
  bool busy_ = false;
  bool stopping_ = false;
  double cpu_seconds_ = 0.0;
  std::thread thread_;
};

}  // namespace cls::base
