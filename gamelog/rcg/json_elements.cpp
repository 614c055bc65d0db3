// Tracks strings and depth, without parsing values.
#include "gamelog/rcg/json_elements.h"

#include <algorithm>
#include <string_view>

namespace cls::gamelog {
namespace {

constexpr std::size_t kFirstElement = 4096;  // of any server: version, time, or the header
constexpr std::size_t kBlock = 64 * 1024;

}  // namespace

bool has_other_lines(base::InputBuffer& input) {
  const std::string_view start = input.peek(kFirstElement);
  const std::size_t begin = start.find('{');
  const std::size_t end = start.find('}', begin);
  if (begin == start.npos) return false;
  if (end == start.npos) return start.find('\n', begin) != start.npos;
  if (start.substr(begin, end - begin).find('\n') != start.npos) return true;

  const std::size_t next = start.find_first_not_of("} ,\t\r", end);
  return next != start.npos && start[next] == '{';
}

std::size_t ElementLines::read(char* to, std::size_t size) {
  const std::string_view bytes = input_.take(std::min(size, kBlock));
  std::ranges::transform(bytes, to, [this](char c) { return line_form(c); });
  if (bytes.empty() && !input_.source().error().empty()) fail(input_.source().error());
  return bytes.size();
}

char ElementLines::line_form(char c) {
  if (in_string_) {
    const bool ends = c == '"' && !escaped_;
    escaped_ = c == '\\' && !escaped_;
    in_string_ = !ends;
    return c;
  }

  if (c == '"') in_string_ = true;
  if (c == '[' || c == '{') ++depth_;
  if (c == ']' || c == '}') --depth_;
  if (depth_ > 1 && (c == '\n' || c == '\r')) return ' ';
  return depth_ == 1 && c == ',' ? '\n' : c;
}

}  // namespace cls::gamelog
