// Texts without the white space around them.
#pragma once

#include <string_view>

namespace cls::base {

/// `text` without the characters of `around` at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view around = " \t\r\n") {
  const std::size_t begin = text.find_first_not_of(around);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(around) - begin + 1);
}

}  // namespace cls::base
