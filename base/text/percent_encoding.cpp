// The unreserved characters of RFC 3986 stay.
#include "base/text/percent_encoding.h"

#include <fmt/format.h>

#include <cctype>

namespace cls::base {

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kPlain = "/-._~";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || kPlain.find(c) != std::string_view::npos;
    text += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return text;
}

}  // namespace cls::base
