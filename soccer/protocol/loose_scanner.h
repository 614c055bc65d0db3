// A cursor for texts that the real server reads with scanf: blanks are free, endings forgiven.
#pragma once

#include <cstddef>
#include <string_view>

#include "soccer/protocol/wrapped_int.h"

namespace cls::soccer {

/// Steps return whether they matched; a step that did not may have skipped blanks, nothing else.
class LooseScanner {
 public:
  explicit LooseScanner(std::string_view text) : text_(text) {}

  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  std::string_view rest() const { return text_.substr(at_); }
  bool looking_at(std::string_view text) const { return rest().starts_with(text); }

  void skip_blanks() {
    while (!at_end() && is_blank(text_[at_])) ++at_;
  }

  /// Advances to the next `c` or to the end.
  void skip_to(char c) {
    const std::size_t found = text_.find(c, at_);
    at_ = found == std::string_view::npos ? text_.size() : found;
  }

  /// Blanks, then `text`.
  bool token(std::string_view text) {
    skip_blanks();
    if (!looking_at(text)) return false;
    at_ += text.size();
    return true;
  }

  /// Blanks, then a number; unlike in player commands "5." is one.
  bool number(double& value) {
    skip_blanks();
    const std::size_t length = base::read_number(rest(), value);
    at_ += length;
    if (length > 0 && peek() == '.') ++at_;
    return length > 0;
  }

  /// Blanks, then an integer.
  bool integer(int& value) {
    skip_blanks();
    const std::size_t length = read_wrapped_int(rest(), value);
    at_ += length;
    return length > 0;
  }

  /// Blanks, then up to `limit` characters that `accepted(c)` takes; may be empty.
  template <typename Accepted>
  std::string_view run(Accepted accepted, std::size_t limit) {
    skip_blanks();
    const std::size_t start = at_;
    while (!at_end() && at_ - start < limit && accepted(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace cls::soccer
