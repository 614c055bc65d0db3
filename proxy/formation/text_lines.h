// Reading text line by line and word by word, with the place for error messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/geometry.h"

namespace cls::proxy {

/// Lines without comments ('#' or "//" to the end of the line); empty ones are passed over.
class TextLines {
 public:
  /// Both must outlive the object; `name` begins error messages.
  TextLines(std::string_view text, const std::string& name) : rest_(text), name_(&name) {}

  /// Goes to the next line that holds something; false at the end.
  bool next();
  /// The words of the present line, separated by blanks or by `separator`; at least one.
  std::vector<std::string_view> words(char separator = ' ') const;

  /// Names the file and the present line.
  base::Error error(const std::string& what) const;

  static std::optional<double> number(std::string_view word);
  static std::optional<soccer::Vec2> point(std::string_view x, std::string_view y);
  /// 1 to 11.
  static std::optional<int> unum(std::string_view word);

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
  const std::string* name_;
};

}  // namespace cls::proxy
