// Greedy line breaking at spaces.
#include "base/text/wrap_text.h"

namespace cls::base {

std::string wrap_text(std::string_view text, std::size_t width) {
  std::string lines(text);
  std::size_t line = 0;                  // start of the current line
  std::size_t last = std::string::npos;  // its last space so far
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == '\n') {
      line = i + 1;
      last = std::string::npos;
    } else if (lines[i] == ' ') {
      last = i;
    }
    if (i - line < width || last == std::string::npos || lines[i] == '\n') continue;
    lines[last] = '\n';
    line = last + 1;
    last = std::string::npos;
  }
  return lines;
}

}  // namespace cls::base
