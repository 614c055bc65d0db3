// A forgiving walk through one line of JSON.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::base {

/// Steps return false once something is not as expected; where, position() tells. Strings may hold
/// any bytes (a real server writes control characters and broken UTF-8). Behind the text there must
/// be a line feed and 64 readable bytes (InputBuffer).
class JsonCursor {
 public:
  explicit JsonCursor(std::string_view text)
      : start_(text.data()), at_(text.data()), end_(text.data() + text.size()) {}

  /// For objects: `if (in.open('{')) while (in.next_key(key)) ...; in.good()`. Between two keys the
  /// value must be consumed. False at the closing bracket, and when something is wrong.
  bool next_key(std::string_view& key);

  /// A key as it is meant: next_key() gives it with its escapes.
  static std::string unescaped(std::string_view raw);

  /// The same for arrays: true if there is another element.
  bool next_element();

  bool open(char bracket);

  bool number(double& value);
  bool integer(int& value);
  bool string(std::string& value);          ///< without quotes and escapes
  bool string_or_null(std::string& value);  ///< null is the empty string
  bool skip_value();

  /// The value as text: a number as it stands, true and false as 1 and 0, a string in quotes
  /// without escapes. False for anything else.
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
  void blanks();
  bool raw_string(std::string_view& value);
  bool separator(char closing);

  const char* start_;
  const char* at_;
  const char* end_;
  bool first_ = false;
  bool good_ = true;
};

}  // namespace cls::base
