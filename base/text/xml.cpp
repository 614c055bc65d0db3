// Escapes characters that are markup in XML.
#include "base/text/xml.h"

#include <algorithm>
#include <array>

#include "base/text/printable.h"
#include "base/text/utf8.h"

namespace cls::base {
namespace {

constexpr std::string_view kMarks = "&<>\"";
constexpr std::array<std::string_view, kMarks.size()> kEscapes = {"&amp;", "&lt;", "&gt;",
                                                                  "&quot;"};

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = utf8_sequence_length(text);
    const char c = text.front();

    if (const std::size_t mark = kMarks.find(c); mark != std::string_view::npos) {
      escaped += kEscapes[mark];
    } else if (printable_length(text) == 0 && c != '\n' && c != '\t') {
      escaped += '?';
    } else {
      escaped += text.substr(0, length);
    }

    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

}  // namespace cls::base
