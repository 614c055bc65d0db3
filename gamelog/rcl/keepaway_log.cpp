// Formats the header and lines of a keepaway log.
#include "gamelog/rcl/keepaway_log.h"

#include "base/text/number_text.h"

namespace cls::gamelog {

using base::append_g;
using base::append_int;

void KeepawayLogWriter::write_header(int keepers, int takers, double length, double width) {
  text_ = "# Keepers: ";
  append_int(keepers, text_);
  text_ += "\n# Takers:  ";
  append_int(takers, text_);
  text_ += "\n# Region:  ";
  append_g(length, text_);
  text_ += " x ";
  append_g(width, text_);

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
  for (const int value : {number, start, end, end - start}) {
    append_int(value, text_);
    text_ += '\t';
  }

  text_ += static_cast<char>(loss);
  text_ += '\n';
  sink_.write(text_);
}

}  // namespace cls::gamelog
