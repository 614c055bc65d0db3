// Reading XPM pictures.
#include "soccer/commands/xpm.h"

#include "base/text/number_text.h"
#include "soccer/protocol/loose_scanner.h"

namespace cls::soccer {
namespace {

constexpr int kMaxLines = 4096;
constexpr int kMaxWidth = 8191;

struct Header {
  int width = 0;
  int height = 0;
  int colours = 0;
  int characters_per_pixel = 0;
};

bool read_header(LooseScanner& in, Header& header) {
  if (!(in.token("\"") && in.integer(header.width) && in.integer(header.height) &&
        in.integer(header.colours) && in.integer(header.characters_per_pixel) && in.token("\""))) {
    return false;
  }
  const auto in_range = [](int value, int limit) { return value >= 0 && value <= limit; };
  return in_range(header.width, kMaxWidth) && in_range(header.height, kMaxLines) &&
         in_range(header.colours, kMaxLines) && in_range(header.characters_per_pixel, kMaxWidth);
}

std::string text_of(const Header& header) {
  std::string text;
  for (const int value :
       {header.width, header.height, header.colours, header.characters_per_pixel}) {
    if (!text.empty()) text.push_back(' ');
    base::append_int(value, text);
  }
  return text;
}

bool read_line(LooseScanner& in, std::vector<std::string>& out) {
  if (!in.token("\"")) return false;
  const std::string_view rest = in.rest();
  const std::size_t length = rest.find('"');
  if (length == std::string_view::npos || length == 0) return false;
  out.emplace_back(rest.substr(0, length));
  in.skip_to('"');
  return in.token("\"");
}

}  // namespace

bool read_xpm(std::string_view text, std::vector<std::string>& out) {
  out.clear();
  LooseScanner in(text);
  Header header;
  if (!read_header(in, header)) return false;
  out.push_back(text_of(header));
  for (int i = 0; i < header.colours; ++i) {
    if (!read_line(in, out)) return false;
  }
  const auto line_size = static_cast<std::size_t>(header.width) *
                         static_cast<std::size_t>(header.characters_per_pixel);
  for (int i = 0; i < header.height; ++i) {
    if (!read_line(in, out) || out.back().size() != line_size) return false;
  }
  return true;
}

}  // namespace cls::soccer
