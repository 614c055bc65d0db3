// Splits text into lines, tokens and numbers.
#include "player/formation/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/value_text.h"
#include "soccer/side.h"

namespace cls::player {

bool TextLines::next() {
  constexpr std::string_view kWhitespace = " \t\r";
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++number_;
    line_ = line_.substr(0, std::min(line_.find('#'), line_.find("//")));
    if (line_.find_first_not_of(kWhitespace) != std::string_view::npos) return true;
  }

  line_ = {};
  return false;
}

std::vector<std::string_view> TextLines::tokens(char separator) const {
  const std::string separators = std::string(" \t\r") + separator;
  std::vector<std::string_view> tokens;

  for (std::size_t at = line_.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(line_.find_first_of(separators, at), line_.size());
    tokens.push_back(line_.substr(at, end - at));
    at = line_.find_first_not_of(separators, end);
  }

  if (tokens.empty()) tokens.emplace_back();  // separators alone
  return tokens;
}

base::Error TextLines::error(const std::string& what) const {
  return {fmt::format("{}:{}: {}", *name_, number_, what)};
}

std::optional<Vec2> TextLines::parse_point(std::string_view x, std::string_view y) {
  // Positions farther away are typos.
  constexpr double kMaxCoordinate = 200.0;
  const auto px = base::value_of<double>(x);
  const auto py = base::value_of<double>(y);
  if (!px || !py || std::fabs(*px) > kMaxCoordinate || std::fabs(*py) > kMaxCoordinate) {
    return std::nullopt;
  }
  return Vec2{*px, *py};
}

std::optional<int> TextLines::parse_unum(std::string_view token) {
  const auto value = base::value_of<int>(token);
  return value && *value >= 1 && *value <= soccer::kPlayersPerTeam ? value : std::nullopt;
}

}  // namespace cls::player
