// A tolerant pull parser for one line of JSON (game logs are parsed in the hot path).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::base {

/// Functions return false from the first syntax error on; position() is its offset. Strings may
/// hold any bytes, because rcssserver writes control characters and invalid UTF-8. A line feed and
/// 64 readable bytes must follow the text (InputBuffer).
class JsonCursor {
 public:
  explicit JsonCursor(std::string_view text)
      : start_(text.data()), at_(text.data()), end_(text.data() + text.size()) {}

  /// For objects: `if (in.open('{')) while (in.next_key(key)) ...; in.good()`. The caller consumes
  /// the value after each key. False at the closing bracket and after an error.
  bool next_key(std::string_view& key);

  /// Resolves the escapes in a key returned by next_key().
  static std::string unescape(std::string_view raw);

  /// For arrays: true if there is another element.
  bool next_element();

  bool open(char bracket);

  bool number(double& value);
  bool integer(int& value);
  bool string(std::string& value);          ///< without quotes, escapes resolved
  bool string_or_null(std::string& value);  ///< null yields the empty string
  bool skip_value();

  /// The value as text: a number unchanged, true and false as 1 and 0, a string in quotes with its
  /// escapes resolved. False for any other value.
  bool scalar_text(std::string& out);

  char peek();
  bool at_end();
  bool good() const { return good_; }
  std::size_t position() const { return static_cast<std::size_t>(at_ - start_); }

 private:
  bool fail() {
    good_ = false;
    return false;
  }
  void skip_space();
  bool raw_string(std::string_view& value);
  bool separator(char closing);

  const char* start_;
  const char* at_;
  const char* end_;
  bool first_ = false;
  bool good_ = true;
};

}  // namespace cls::base
