// Error messages of the scanner.
#include "soccer/protocol/scanner.h"

#include <fmt/format.h>

namespace cls::soccer {
namespace {

constexpr std::size_t kMaxQuoted = 16;

// Short and printable, because messages come from the network.
std::string printable(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, kMaxQuoted)) {
    const bool is_printable = c >= ' ' && c <= '~';
    result +=
        is_printable ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return text.size() > kMaxQuoted ? result + "..." : result;
}

}  // namespace

base::Error Scanner::error(std::string_view message_name) const {
  assert(!expected_.empty());
  const std::string_view found = text_.substr(failed_at_);
  return base::Error{
      fmt::format("{}: byte {}: expected '{}', found {}", message_name, failed_at_, expected_,
                  found.empty() ? std::string("the end") : "'" + printable(found) + "'")};
}

}  // namespace cls::soccer
