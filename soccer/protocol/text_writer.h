// Builds messages from many small pieces.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

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

namespace detail {

inline void append_piece(TextWriter& out, char c) { out.push_back(c); }
inline void append_piece(TextWriter& out, std::string_view text) { out.append(text); }
inline void append_piece(TextWriter& out, int value) { out.append_number(value); }
inline void append_piece(TextWriter& out, double value) { out.append_number(value); }
inline void append_piece(std::string& out, char c) { out.push_back(c); }
inline void append_piece(std::string& out, std::string_view text) { out.append(text); }
inline void append_piece(std::string& out, int value) { base::append_int(value, out); }
inline void append_piece(std::string& out, double value) { base::append_g(value, out); }

}  // namespace detail

/// Appends characters, texts and numbers one after the other to a TextWriter or std::string;
/// numbers as by append_g and append_int.
template <typename Out, typename... Pieces>
requires(std::is_same_v<Out, TextWriter> ||
         std::is_same_v<Out, std::string>) void append(Out& out, const Pieces&... pieces) {
  (detail::append_piece(out, pieces), ...);
}

}  // namespace cls::soccer
