// Threads that repeat one task over equal shares of a range.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace cls::training {

/// A share is the same block of indices in every run, so that worlds stay in one thread's cache.
class Crew {
 public:
  /// `work(begin, end)` must not throw. Threads start with the first run().
  Crew(std::size_t count, std::size_t threads, std::function<void(std::size_t, std::size_t)> work);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Works on all shares, one of them on this thread, and waits for all.
  void run();

  std::size_t threads() const { return threads_; }

 private:
  void start();
  void loop(std::size_t share);
  void work_on(std::size_t share);

  std::size_t count_;
  std::size_t threads_;
  std::function<void(std::size_t, std::size_t)> work_;
  std::vector<std::thread> others_;
  int spins_;  ///< looks at a counter before a thread sleeps
  // Apart, so that a thread that looks at one is not disturbed by the other.
  alignas(64) std::atomic<unsigned> round_ = 0;
  alignas(64) std::atomic<unsigned> unfinished_ = 0;
  std::atomic<bool> stopping_ = false;
};

}  // namespace cls::training
