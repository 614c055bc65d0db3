// Writes a text log (rcl): received commands and referee messages.
#pragma once

#include <string>
#include <string_view>

#include "base/io/byte_sink.h"

namespace cls::gamelog {

/// The clock of a line: game time, and cycles since the clock was stopped.
struct Stamp {
  int time = 0;
  int stopped = 0;
};

// Format a received datagram as logs do: sender, and text up to a NUL byte.
void append_player_command(std::string_view team, int unum, std::string_view text,
                           std::string& out);
void append_coach_command(std::string_view team, std::string_view text, std::string& out);
void append_trainer_command(std::string_view text, std::string& out);

/// Writes one line per call into `sink`, which must outlive the writer
/// (docs/spec/log-formats.md 2). Received text is logged unparsed, including illegal commands. A
/// line is cut after 8191 characters, as in rcssserver.
class RclWriter {
 public:
  explicit RclWriter(base::ByteSink& sink) : sink_(sink) { line_.reserve(kTypicalLine); }

  /// `received` is the output of append_player_command(), append_coach_command() or
  /// append_trainer_command().
  void write_command(Stamp stamp, std::string_view received);

  /// `message` is a play mode or another referee message, without brackets.
  void write_referee(Stamp stamp, std::string_view message);

 private:
  static constexpr std::size_t kTypicalLine = 1024;  ///< bytes

  base::ByteSink& sink_;
  std::string line_;
};

}  // namespace cls::gamelog
