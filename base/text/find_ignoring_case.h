// Searches texts in any case.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace cls::base {

/// Where `word` begins in `text`, whatever the case of ASCII letters; npos if it does not occur.
inline std::size_t find_ignoring_case(std::string_view text, std::string_view word) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  const auto found = std::search(text.begin(), text.end(), word.begin(), word.end(), same);
  const bool absent = found == text.end() && !word.empty();
  return absent ? std::string_view::npos : static_cast<std::size_t>(found - text.begin());
}

}  // namespace cls::base
