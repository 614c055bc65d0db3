// Progress line while several logs are read, or other work of many equal parts is done.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "cli/terminal/terminal.h"

namespace cls::cli {

/// Shown for more than one part: a bar on a terminal, elsewhere a line each half minute.
class LogProgress {
 public:
  explicit LogProgress(std::size_t parts, const char* parts_name = "logs");

  /// Reports the number of parts that are done. Thread-safe.
  void update(std::size_t count);

 private:
  using Clock = std::chrono::steady_clock;

  std::string status(std::size_t count, double elapsed) const;

  std::size_t parts_;
  const char* parts_name_;
  bool on_terminal_;
  bool shown_;
  std::mutex mutex_;
  TerminalLine line_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_ = on_terminal_ ? Clock::time_point() : start_;
};

}  // namespace cls::cli
