// Classes of characters by code point.
#include "base/text/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include "base/text/lines.h"
#include "base/text/utf8.h"

namespace cls::base {
namespace {

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

// Control characters of ASCII and of ISO 6429 (C1); characters of Unicode that a terminal or page
// does not show, or that reorder others (General_Category Cf, Zl, Zp).
constexpr std::array kUnprintable = std::to_array<Range>({
    {0x00, 0x1F},
    {0x7F, 0x9F},
    {0xAD, 0xAD},
    {0x61C, 0x61C},
    {0x180E, 0x180E},
    {0x200B, 0x200F},
    {0x2028, 0x202E},
    {0x2060, 0x206F},
    {0xFEFF, 0xFEFF},
    {0xFFF9, 0xFFFB},
    {0xE0000, 0xE007F},
});

bool is_unprintable(std::uint32_t code) {
  return std::ranges::any_of(kUnprintable, [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

// The code point of a well-formed sequence.
std::uint32_t code_point(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  constexpr std::array<std::uint32_t, 5> kFirstBits = {0, 0x7F, 0x1F, 0x0F, 0x07};
  std::uint32_t code = byte(0) & kFirstBits.at(sequence.size());
  for (std::size_t i = 1; i < sequence.size(); ++i) code = code << 6 | (byte(i) & 0x3F);
  return code;
}

// Nearly all texts hold nothing else.
bool is_plain(char c) { return c >= ' ' && c < '\x7F'; }

std::string escape(std::uint32_t code) {
  constexpr std::uint32_t kPlane = 0x10000;
  std::array<char, 16> text{};
  if (code < kPlane) {
    std::snprintf(text.data(), text.size(), "\\u%04x", code);
  } else {
    const std::uint32_t rest = code - kPlane;
    std::snprintf(text.data(), text.size(), "\\u%04x\\u%04x", 0xD800 + (rest >> 10),
                  0xDC00 + (rest & 0x3FF));
  }
  return text.data();
}

}  // namespace

std::size_t printable_length(std::string_view text) {
  if (is_plain(text.front())) return 1;
  const std::size_t length = utf8_sequence_length(text);
  return length == 0 || is_unprintable(code_point(text.substr(0, length))) ? 0 : length;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = printable_length(text);
    if (length > 0) {
      result += text.substr(0, length);
    } else {
      result += text.front() == '\t' ? ' ' : '?';
    }

    const std::size_t skipped = length > 0 ? length : utf8_sequence_length(text);
    text.remove_prefix(std::max<std::size_t>(skipped, 1));
  }
  return result;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  for (const std::string_view line : lines_of(text)) result += printable(line) + '\n';
  if (!text.ends_with('\n') && !text.empty()) result.pop_back();
  return result;
}

// Such characters occur only within strings.
std::string printable_json(std::string json) {
  if (std::ranges::all_of(json, [](char c) { return is_plain(c) || c == '\n'; })) return json;

  std::string result;
  std::string_view rest = json;
  while (!rest.empty()) {
    std::size_t length = rest.front() == '\n' ? 1 : printable_length(rest);
    const bool safe = length > 0;
    if (!safe) length = std::max<std::size_t>(utf8_sequence_length(rest), 1);

    result +=
        safe ? std::string(rest.substr(0, length)) : escape(code_point(rest.substr(0, length)));
    rest.remove_prefix(length);
  }
  return result;
}

}  // namespace cls::base
