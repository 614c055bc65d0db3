// Text as a cell of CSV (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// In double quotes, those of the text doubled, where commas, quotes or line ends demand it.
inline std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace cls::base
