// Writing a text log (rcl): every received command and every word of the referee.
#pragma once

#include <string>
#include <string_view>

#include "base/io/byte_sink.h"

namespace cls::gamelog {

/// The clock of a line: game time, and how long it has stood still.
struct Stamp {
  int time = 0;
  int stopped = 0;
};

// What logs say of a received datagram: from whom, and its text up to a NUL byte.
void append_player_command(std::string_view team, int unum, std::string_view text,
                           std::string& out);
void append_coach_command(std::string_view team, std::string_view text, std::string& out);
void append_trainer_command(std::string_view text, std::string& out);

/// One line per call into `sink`, which must outlive the writer (log-formats 2). Received text is
/// logged as it came, before it is read: illegal commands too; a line is cut at 8191 characters
/// behind its stamp, as in the real server.
class RclWriter {
 public:
  explicit RclWriter(base::ByteSink& sink) : sink_(sink) { line_.reserve(kUsualLine); }

  /// `received` is what append_player_command and its kind write.
  void command(Stamp stamp, std::string_view received);

  /// `message` is a play mode or another referee word, without brackets.
  void referee(Stamp stamp, std::string_view message);

 private:
  void begin(Stamp stamp);

  static constexpr std::size_t kUsualLine = 1024;  ///< bytes

  base::ByteSink& sink_;
  std::string line_;
};

}  // namespace cls::gamelog
