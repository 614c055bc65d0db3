// Formats the lines of a text log.
#include "gamelog/rcl/rcl_writer.h"

#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::append;

constexpr std::size_t kMaxText = 8191;

std::string_view until_nul(std::string_view text) { return text.substr(0, text.find('\0')); }

}  // namespace

void append_player_command(std::string_view team, int unum, std::string_view text,
                           std::string& out) {
  append(out, "Recv ", team, '_', unum, ": ", until_nul(text));
}

void append_coach_command(std::string_view team, std::string_view text, std::string& out) {
  append(out, "Recv ", team, "_Coach: ", until_nul(text));
}

void append_trainer_command(std::string_view text, std::string& out) {
  append(out, "Recv Coach: ", until_nul(text));
}

void RclWriter::write_command(Stamp stamp, std::string_view received) {
  line_.clear();
  append(line_, stamp.time, ',', stamp.stopped, '\t', received.substr(0, kMaxText), '\n');
  sink_.write(line_);
}

void RclWriter::write_referee(Stamp stamp, std::string_view message) {
  line_.clear();
  append(line_, stamp.time, ',', stamp.stopped, "\t(referee ", message, ")\n");
  sink_.write(line_);
}

}  // namespace cls::gamelog
