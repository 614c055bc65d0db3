// Reads text line by line and token by token, with file and line for error messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/geometry.h"

namespace cls::player {

using soccer::Vec2;

/// Skips comments ('#' or "//" to the end of the line) and empty lines.
class TextLines {
 public:
  /// Both must outlive the object; `name` begins error messages.
  TextLines(std::string_view text, const std::string& name) : rest_(text), name_(&name) {}

  /// Advances to the next non-empty line; false at the end.
  bool next();
  /// Tokens of the current line, separated by whitespace or `separator`; at least one, which is
  /// empty in a line of separators alone.
  std::vector<std::string_view> tokens(char separator = ' ') const;

  /// Error with file name and current line number.
  base::Error error(const std::string& what) const;

  static std::optional<Vec2> parse_point(std::string_view x, std::string_view y);
  /// The point in the tokens `first` and the next one, if there are `count` tokens.
  static std::optional<Vec2> parse_point(const std::vector<std::string_view>& tokens,
                                         std::size_t first, std::size_t count) {
    if (tokens.size() != count) return std::nullopt;
    return parse_point(tokens[first], tokens[first + 1]);
  }
  /// 1 to 11.
  static std::optional<int> parse_unum(std::string_view token);

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
  const std::string* name_;
};

}  // namespace cls::player
