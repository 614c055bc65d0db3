// The one line that says where a message could not be read.
#include "soccer/protocol/scanner.h"

#include <fmt/format.h>

namespace cls::soccer {
namespace {

constexpr std::size_t kShown = 16;

// Printable and short: messages come from the network.
std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, kShown)) {
    const bool printable = c >= ' ' && c <= '~';
    result +=
        printable ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return text.size() > kShown ? result + "..." : result;
}

}  // namespace

base::Error Scanner::error(std::string_view message_name) const {
  assert(!expected_.empty());
  const std::string_view found = text_.substr(failed_at_);
  return base::Error{
      fmt::format("{}: byte {}: expected '{}', found {}", message_name, failed_at_, expected_,
                  found.empty() ? std::string("the end") : "'" + shown(found) + "'")};
}

}  // namespace cls::soccer
