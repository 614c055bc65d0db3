// The byte order mark, with which editors on Windows begin texts in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Removes it from the begin of `text`.
inline void remove_byte_order_mark(std::string& text) {
  if (text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) {
    text.erase(0, kByteOrderMark.size());
  }
}

}  // namespace cls::base
