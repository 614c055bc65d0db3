// The lines of a text log.
#include "gamelog/rcl_writer.h"

#include <algorithm>

#include "soccer/protocol/number_text.h"

namespace cls::gamelog {
namespace {

constexpr std::size_t kMaxText = 8191;

}  // namespace

void RclWriter::player_command(Stamp stamp, std::string_view team, int unum,
                               std::string_view text) {
  begin(stamp);
  line_ += "Recv ";
  line_ += team;
  line_ += '_';
  soccer::append_int(unum, line_);
  end(text);
}

void RclWriter::coach_command(Stamp stamp, std::string_view team, std::string_view text) {
  begin(stamp);
  line_ += "Recv ";
  line_ += team;
  line_ += "_Coach";
  end(text);
}

void RclWriter::trainer_command(Stamp stamp, std::string_view text) {
  begin(stamp);
  line_ += "Recv Coach";
  end(text);
}

void RclWriter::referee(Stamp stamp, std::string_view message) {
  begin(stamp);
  line_ += "(referee ";
  line_ += message;
  line_ += ")\n";
  sink_.write(line_);
}

void RclWriter::begin(Stamp stamp) {
  line_.clear();
  soccer::append_int(stamp.time, line_);
  line_ += ',';
  soccer::append_int(stamp.stopped, line_);
  line_ += '\t';
}

void RclWriter::end(std::string_view text) {
  const std::size_t stamp_end = line_.find('\t') + 1;
  line_ += ": ";
  line_ += text.substr(0, std::min(text.find('\0'), text.size()));
  if (line_.size() > stamp_end + kMaxText) line_.resize(stamp_end + kMaxText);
  line_ += '\n';
  sink_.write(line_);
}

}  // namespace cls::gamelog
