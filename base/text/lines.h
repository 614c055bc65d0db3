// Lines of texts.
#pragma once

#include <algorithm>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace cls::base {

/// The lines without their line feeds, as views into `text`; the last one may lack its line feed.
inline std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    lines.push_back(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(lines.back().size() + 1, text.size()));
  }
  return lines;
}

/// The views would outlive a temporary text.
template <std::same_as<std::string> Text>
void lines_of(Text&& text) = delete;

/// The text up to its first line feed.
inline std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace cls::base
