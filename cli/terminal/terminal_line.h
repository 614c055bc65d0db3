// One line on a terminal that is written over and over.
#pragma once

#include <string>
#include <string_view>

namespace cls::cli {

/// On stderr. Cuts what is wider than the terminal.
class TerminalLine {
 public:
  TerminalLine() = default;
  ~TerminalLine() { clear(); }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  void show(std::string_view text);

  /// Removes the line, so that what is printed next starts on a clean one.
  void clear();

 private:
  bool visible_ = false;
};

/// "[#####...............]"
std::string progress_bar(double share);

/// "17 s left", "2:05 min left"
std::string time_left(double seconds);

}  // namespace cls::cli
