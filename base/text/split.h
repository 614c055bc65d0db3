// Splits texts at a character.
#pragma once

#include <string_view>
#include <vector>

namespace cls::base {

/// The pieces between separators, empty ones too, as views into `text`; one piece without a
/// separator.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    pieces.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  pieces.push_back(text);
  return pieces;
}

}  // namespace cls::base
