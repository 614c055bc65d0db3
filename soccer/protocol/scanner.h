// A cursor over a server message: single pass, no allocation, records the first error.
#pragma once

#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text/number_text.h"

namespace cls::soccer {

/// No server counts further in a match, and sums of up to eight such integers fit an int.
constexpr int kMaxInteger = (1 << 28) - 1;

/// Each function consumes its text and returns true, or leaves the cursor unchanged, records the
/// expected text and returns false; a message is one chain of calls joined with &&. Expected texts
/// must outlive the scanner, as string literals do.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  std::size_t position() const { return at_; }
  std::string_view rest() const { return text_.substr(at_); }

  /// The next character; NUL at the end.
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  bool looking_at(std::string_view expected) const { return rest().starts_with(expected); }

  /// Consumes `expected`; a mismatch is an error.
  bool literal(std::string_view expected) {
    if (!looking_at(expected)) return fail(expected);
    at_ += expected.size();
    return true;
  }

  /// Consumes `wanted` if it is next; its absence is not an error.
  bool optional(std::string_view wanted) {
    if (!looking_at(wanted)) return false;
    at_ += wanted.size();
    return true;
  }

  bool number(double& value) {
    const std::size_t length = base::parse_number_prefix(rest(), value);
    at_ += length;
    return length > 0 || fail("a number");
  }

  /// Any int.
  bool any_integer(int& value) {
    const std::size_t length = base::parse_int_prefix(rest(), value);
    at_ += length;
    return length > 0 || fail("an integer");
  }

  /// An integer from `low` to `high`.
  bool integer(int& value, int low, int high) {
    const std::size_t start = at_;
    if (!any_integer(value)) return false;
    return (value >= low && value <= high) || fail_at(start, "an integer in range");
  }

  /// A cycle, count, score or angle: at most kMaxInteger in magnitude.
  bool integer(int& value) { return integer(value, -kMaxInteger, kMaxInteger); }

  /// Literals, integers and numbers one after the other.
  template <typename... Parts>
  bool sequence(Parts&&... parts) {
    return (read_part(parts) && ...);
  }

  /// One or more characters up to the next space, parenthesis, quote or the end.
  bool token(std::string_view& value) {
    value = rest().substr(0, rest().find_first_of(" ()\""));
    at_ += value.size();
    return !value.empty() || fail("a token");
  }

  /// All text before `closing`, which must be the end of the message.
  bool rest_before(std::string_view closing, std::string_view& value) {
    value = rest();
    at_ = text_.size();
    if (!value.ends_with(closing)) return fail(closing);

    value.remove_suffix(closing.size());
    return true;
  }

  /// Records the first error; always false.
  bool fail(std::string_view expected) { return fail_at(at_, expected); }
  bool fail_at(std::size_t position, std::string_view expected) {
    if (expected_.empty()) {
      expected_ = expected;
      failed_at_ = position;
    }
    return false;
  }

  /// True at the end of the message; remaining text is an error.
  bool end() { return at_end() || fail("the end"); }

  /// Nothing if all was read, up to the end of the message; else the error.
  base::Result<void> finish(bool read, std::string_view message_name) {
    if (read && end()) return {};
    return error(message_name);
  }

  /// "see: byte 17: expected 'a number', found 'x'". Requires a recorded error.
  base::Error error(std::string_view message_name) const;

 private:
  bool read_part(std::string_view expected) { return literal(expected); }
  bool read_part(int& value) { return integer(value); }
  bool read_part(double& value) { return number(value); }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view expected_;
  std::size_t failed_at_ = 0;
};

}  // namespace cls::soccer
