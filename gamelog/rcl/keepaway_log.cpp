// Formats the header and lines of a keepaway log.
#include "gamelog/rcl/keepaway_log.h"

#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {

using soccer::append;

void KeepawayLogWriter::write_header(int keepers, int takers, double length, double width) {
  text_.clear();
  append(text_, "# Keepers: ", keepers, "\n# Takers:  ", takers, "\n# Region:  ", length, " x ",
         width);
  text_ +=
      "\n#\n"
      "# Description of Fields:\n"
      "# 1) Episode number\n"
      "# 2) Start time in simulator steps (100ms)\n"
      "# 3) End time in simulator steps (100ms)\n"
      "# 4) Duration in simulator steps (100ms)\n"
      "# 5) (o)ut of bounds / (t)aken away\n"
      "#\n";

  sink_.write(text_);
}

void KeepawayLogWriter::write_episode(int number, int start, int end, KeepawayLoss loss) {
  text_.clear();
  append(text_, number, '\t', start, '\t', end, '\t', end - start, '\t', static_cast<char>(loss),
         '\n');
  sink_.write(text_);
}

}  // namespace cls::gamelog
