// Lines, words, numbers.
#include "proxy/formation/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "soccer/side.h"

namespace cls::proxy {

bool TextLines::next() {
  constexpr std::string_view kBlank = " \t\r";
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++number_;
    line_ = line_.substr(0, std::min(line_.find('#'), line_.find("//")));
    if (line_.find_first_not_of(kBlank) != std::string_view::npos) return true;
  }
  line_ = {};
  return false;
}

std::vector<std::string_view> TextLines::words(char separator) const {
  const std::string separators = std::string(" \t\r") + separator;
  std::vector<std::string_view> words;
  for (std::size_t at = line_.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(line_.find_first_of(separators, at), line_.size());
    words.push_back(line_.substr(at, end - at));
    at = line_.find_first_not_of(separators, end);
  }
  return words;
}

base::Error TextLines::error(const std::string& what) const {
  return {fmt::format("{}:{}: {}", *name_, number_, what)};
}

std::optional<double> TextLines::number(std::string_view word) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<soccer::Vec2> TextLines::point(std::string_view x, std::string_view y) {
  // Nobody belongs farther away than this; it is a slip of the pen.
  constexpr double kFarthest = 200.0;
  const auto px = number(x);
  const auto py = number(y);
  if (!px || !py || std::fabs(*px) > kFarthest || std::fabs(*py) > kFarthest) return std::nullopt;
  return soccer::Vec2{*px, *py};
}

std::optional<int> TextLines::unum(std::string_view word) {
  int value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (value < 1 || value > soccer::kPlayersPerTeam) return std::nullopt;
  return value;
}

}  // namespace cls::proxy
