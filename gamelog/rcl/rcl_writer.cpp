// Formats the lines of a text log.
#include "gamelog/rcl/rcl_writer.h"

#include <algorithm>

#include "base/text/number_text.h"

namespace cls::gamelog {
namespace {

constexpr std::size_t kMaxText = 8191;

void append_text(std::string_view text, std::string& out) {
  out += ": ";
  out += text.substr(0, std::min(text.find('\0'), text.size()));
}

}  // namespace

void append_player_command(std::string_view team, int unum, std::string_view text,
                           std::string& out) {
  out += "Recv ";
  out += team;
  out += '_';
  base::append_int(unum, out);
  append_text(text, out);
}

void append_coach_command(std::string_view team, std::string_view text, std::string& out) {
  out += "Recv ";
  out += team;
  out += "_Coach";
  append_text(text, out);
}

void append_trainer_command(std::string_view text, std::string& out) {
  out += "Recv Coach";
  append_text(text, out);
}

void RclWriter::write_command(Stamp stamp, std::string_view received) {
  start_line(stamp);
  line_ += received.substr(0, kMaxText);
  line_ += '\n';
  sink_.write(line_);
}

void RclWriter::write_referee(Stamp stamp, std::string_view message) {
  start_line(stamp);
  line_ += "(referee ";
  line_ += message;
  line_ += ")\n";
  sink_.write(line_);
}

void RclWriter::start_line(Stamp stamp) {
  line_.clear();
  base::append_int(stamp.time, line_);
  line_ += ',';
  base::append_int(stamp.stopped, line_);
  line_ += '\t';
}

}  // namespace cls::gamelog
