// The terminal on stderr and stdout: capabilities and a status line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::cli {

/// True when stderr is a terminal that supports cursor movement.
bool stderr_is_terminal();

/// Options that every command has.
struct OutputOptions {
  bool no_color = false;
  bool quiet = false;  ///< of commands that do not declare --quiet themselves
};

/// Those of this process; run_application() resets them.
OutputOptions& output_options();

/// True when stdout is a terminal and none of NO_COLOR, TERM=dumb and `--no-color` disables color.
/// CLICOLOR_FORCE replaces the terminal.
bool stdout_supports_color();

/// Columns of the terminal on stderr; 80 when unknown.
int terminal_width();

bool stdout_is_terminal();

/// Columns of the terminal on stdout; 80 without one.
std::size_t stdout_width();

/// "cls: TEXT" for stderr, folded at words on a terminal.
std::string message_line(std::string_view text);

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

/// "17 s", "2:05 min", "3:20 h"
std::string duration_text(double seconds);

/// "17 s left", "2:05 min left", "3:20 h left"
std::string time_left(double seconds);

}  // namespace cls::cli
