// Progress line while reading several logs.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

#include "cli/terminal/terminal.h"

namespace cls::cli {

/// Shown only on a terminal and for more than one log.
class LogProgress {
 public:
  explicit LogProgress(std::size_t logs);

  /// Reports the number of logs read. Thread-safe.
  void update(std::size_t count);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t logs_;
  bool shown_;
  std::mutex mutex_;
  TerminalLine line_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_{};
};

}  // namespace cls::cli
