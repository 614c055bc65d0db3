// Escapes characters that are markup in XML.
#include "base/text/xml.h"

#include <algorithm>

#include "base/text/printable.h"
#include "base/text/utf8.h"

namespace cls::base {

std::string escape_xml(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = utf8_sequence_length(text);
    switch (const char c = text.front()) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        if (printable_length(text) == 0 && c != '\n' && c != '\t') {
          escaped += '?';
        } else {
          escaped += text.substr(0, length);
        }
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

}  // namespace cls::base
