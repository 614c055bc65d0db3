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

std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent) {
  std::string lines;
  for (const char c : wrap_text(text, width > indent ? width - indent : 1)) {
    lines += c;
    if (c == '\n') lines.append(indent, ' ');
  }
  return lines;
}

}  // namespace cls::base
