// What a process prints: into a file that cannot grow without bound, and the last lines kept.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

/// Takes output as it comes and cuts it into lines. A line that repeats the one before is not
/// written again; when another follows, a line "  xN" tells how often it stood there. Once the file
/// holds `max_bytes`, nothing more is written until the end, when the number of lines left out and
/// the last lines follow. A line longer than 4096 bytes is cut there.
class OutputLog {
 public:
  static constexpr std::size_t kKeptLines = 50;
  static constexpr std::size_t kMaxLine = 4096;

  OutputLog() = default;
  /// Without a file only the last lines are kept. `on_line` is called with each line.
  OutputLog(UniqueFd file, std::size_t max_bytes,
            std::function<void(std::string_view)> on_line = {});

  void add(std::string_view bytes);
  /// Nothing more will come: takes an unfinished last line, and writes what was held back.
  void finish();

  /// The last lines, oldest first, safe to print and to put into JSON: control characters and bytes
  /// that are no UTF-8 become '?'; a repeated line is one, with " ×N".
  std::vector<std::string> last_lines(std::size_t count = kKeptLines) const;

  /// The first failed write as errno, 0 when all went well.
  int error() const { return error_; }

 private:
  struct Kept {
    std::string text;
    std::size_t times = 1;
  };

  void take_line(std::string_view line);
  void tell_repetitions();
  void write(std::string_view text);

  UniqueFd file_;
  std::size_t room_ = 0;
  std::function<void(std::string_view)> on_line_;
  std::string partial_;
  bool overlong_ = false;  // the rest of an overlong line is being skipped
  std::deque<Kept> kept_;
  std::size_t left_out_ = 0;
  bool full_ = false;
  int error_ = 0;
};

/// `text` with everything that a terminal or JSON cannot take replaced by '?'; tabs become blanks.
std::string printable(std::string_view text);

}  // namespace cls::orchestration::process
