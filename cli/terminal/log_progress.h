// How far the reading of many logs has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

#include "cli/terminal/terminal_line.h"

namespace cls::cli {

/// A line on the terminal, if there is one and there are several logs.
class LogProgress {
 public:
  explicit LogProgress(std::size_t logs);

  /// So many are done. On any thread.
  void done(std::size_t count);

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
