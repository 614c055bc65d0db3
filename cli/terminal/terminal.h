// The terminal on stderr and stdout: capabilities and a status line.
#pragma once

#include <string>
#include <string_view>

namespace cls::cli {

/// True when stderr is a terminal that supports cursor movement.
bool stderr_is_terminal();

/// True when stdout is a terminal and none of NO_COLOR, TERM=dumb and `--no-color` disables color.
bool stdout_supports_color(bool no_color_option);

/// Columns of the terminal on stderr; 80 when unknown.
int terminal_width();

/// A status line on stderr that each show() overwrites; cut to the width of the terminal.
class TerminalLine {
 public:
  TerminalLine() = default;
  ~TerminalLine() { clear(); }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  void show(std::string_view text);

  /// Erases the line.
  void clear();

 private:
  bool visible_ = false;
};

/// "[#####...............]"
std::string progress_bar(double share);

/// "17 s left", "2:05 min left"
std::string time_left(double seconds);

}  // namespace cls::cli
