// Log file of a process's output with a maximum size; the last lines stay in memory.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/system/unique_fd.h"

namespace cls::process {

/// Splits output into lines. A repeated line is written once, followed by "  ×N" with its count.
/// After `max_bytes` nothing more is written until the end, when the number of omitted lines and
/// the last lines follow. Lines are truncated to 4096 bytes.
class OutputLog {
 public:
  static constexpr std::size_t kMaxLastLines = 50;
  static constexpr std::size_t kMaxLineBytes = 4096;

  OutputLog() = default;
  /// Without a file only the last lines are stored. `on_line` is called with each line.
  OutputLog(base::UniqueFd file, std::size_t max_bytes,
            std::function<void(std::string_view)> on_line = {});

  void add(std::string_view bytes);
  /// Calls `on_line` no more.
  void stop_calls() { on_line_ = nullptr; }
  /// End of output: handles an incomplete last line, and writes what was held back.
  void finish();

  /// The last lines, oldest first, safe to print (base::printable); a repeated line is one line
  /// with " ×N".
  std::vector<std::string> last_lines(std::size_t count = kMaxLastLines) const;

  /// errno of the first failed write; 0: none.
  int error() const { return error_; }

 private:
  struct Line {
    std::string text;
    std::size_t times = 1;
  };

  void add_line(std::string_view line);
  void write_repetitions();
  void write(std::string_view text);

  base::UniqueFd file_;
  std::size_t room_ = 0;
  std::function<void(std::string_view)> on_line_;
  std::string partial_;
  bool overlong_ = false;  // the rest of an overlong line is being skipped
  std::deque<Line> last_;
  std::size_t omitted_ = 0;
  bool full_ = false;
  int error_ = 0;
};

}  // namespace cls::process
