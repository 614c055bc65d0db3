// A cursor over text that rcssserver parses with scanf: skips white space, ignores trailing text.
#pragma once

#include <cstddef>
#include <string_view>

#include "soccer/protocol/wrapped_int.h"

namespace cls::soccer {

/// Functions return whether they matched; a mismatch consumes nothing but white space.
class LooseScanner {
 public:
  explicit LooseScanner(std::string_view text) : text_(text) {}

  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  std::string_view rest() const { return text_.substr(at_); }
  bool looking_at(std::string_view text) const { return rest().starts_with(text); }

  void skip_space() {
    while (!at_end() && is_space(text_[at_])) ++at_;
  }

  /// Advances to the next `c` or to the end.
  void skip_to(char c) {
    const std::size_t found = text_.find(c, at_);
    at_ = found == std::string_view::npos ? text_.size() : found;
  }

  /// Skips white space and consumes `text`.
  bool token(std::string_view text) {
    skip_space();
    if (!looking_at(text)) return false;
    at_ += text.size();
    return true;
  }

  /// Skips white space and reads a number; accepts "5.", unlike player commands.
  bool number(double& value) {
    skip_space();
    const std::size_t length = base::parse_number_prefix(rest(), value);
    at_ += length;
    if (length > 0 && peek() == '.') ++at_;
    return length > 0;
  }

  /// Skips white space and reads an integer.
  bool integer(int& value) {
    skip_space();
    const std::size_t length = parse_wrapped_int(rest(), value);
    at_ += length;
    return length > 0;
  }

  /// Skips white space and reads up to `limit` characters for which `accepted(c)`; may be empty.
  template <typename Accepted>
  std::string_view run(Accepted accepted, std::size_t limit) {
    skip_space();
    const std::size_t start = at_;
    while (!at_end() && at_ - start < limit && accepted(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace cls::soccer
