// Builds messages from many small pieces.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/text/number_text.h"

namespace cls::soccer {

/// Buffers pieces and appends them to a string in large parts, the last one in the destructor.
/// Several times as fast as appending each piece to the string.
class TextWriter {
 public:
  explicit TextWriter(std::string& out) : out_(out) {}
  ~TextWriter() { flush(); }
  TextWriter(const TextWriter&) = delete;
  TextWriter& operator=(const TextWriter&) = delete;

  void push_back(char c) {
    make_room(1);
    buffer_[size_++] = c;
  }
  void append(std::string_view text) {
    if (text.size() > kSize) return append_long(text);
    make_room(text.size());
    size_ += text.copy(buffer_.data() + size_, text.size());
  }
  /// Formats like append_g and append_int.
  void append_number(double value) {
    make_room(base::kMaxNumberLength);
    size_ = static_cast<std::size_t>(base::write_g(value, buffer_.data() + size_) - buffer_.data());
  }
  void append_number(int value) {
    make_room(base::kMaxNumberLength);
    size_ =
        static_cast<std::size_t>(base::write_int(value, buffer_.data() + size_) - buffer_.data());
  }

  TextWriter& operator+=(char c) {
    push_back(c);
    return *this;
  }
  TextWriter& operator+=(std::string_view text) {
    append(text);
    return *this;
  }

 private:
  static constexpr std::size_t kSize = 2048;

  void make_room(std::size_t count) {
    if (kSize - size_ < count) flush();
  }
  void flush() {
    out_.append(buffer_.data(), size_);
    size_ = 0;
  }
  void append_long(std::string_view text) {
    flush();
    out_.append(text);
  }

  std::string& out_;
  std::size_t size_ = 0;
  std::array<char, kSize> buffer_;
};

// Each appends `before`, then the number.

inline void append(TextWriter& out, std::string_view before, int value) {
  out.append(before);
  out.append_number(value);
}
inline void append(TextWriter& out, std::string_view before, double value) {
  out.append(before);
  out.append_number(value);
}
inline void append(std::string& out, std::string_view before, int value) {
  out.append(before);
  base::append_int(value, out);
}

}  // namespace cls::soccer
