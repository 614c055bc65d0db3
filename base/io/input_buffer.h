// Reads lines and blocks of bytes from a byte source without copying each of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/byte_source.h"

namespace cls::base {

/// Views are valid until the next call. A line feed and 64 readable bytes follow each view, so that
/// scanners may read ahead without bounds checks.
class InputBuffer {
 public:
  /// Longer lines are corrupt input.
  static constexpr std::size_t kMaxLine = 1024 * 1024;

  explicit InputBuffer(ByteSource& source);

  enum class Line {
    kWhole,       ///< terminated by a line feed
    kUnfinished,  ///< the last line, without a line feed
    kTooLong,     ///< `line` is its start; the rest is skipped
    kEnd,         ///< end of input
  };

  /// The next line, without its line feed.
  Line next_line(std::string_view& line);

  /// The next `size` (<= kMaxLine) bytes; fewer only at the end.
  std::string_view take(std::size_t size);

  /// Up to `size` (<= kMaxLine) next bytes, without consuming them.
  std::string_view peek(std::size_t size);

  /// Offset of the last returned view in the decompressed bytes, from 0.
  std::uint64_t offset() const { return offset_; }

  /// Number of the last returned line, from 1.
  std::uint64_t line_number() const { return line_number_; }

  const ByteSource& source() const { return source_; }

 private:
  std::size_t available() const { return end_ - begin_; }
  bool fill(std::size_t wanted);
  void advance(std::size_t size);
  void skip_line();

  ByteSource& source_;
  std::vector<char> bytes_;
  std::string long_line_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t begin_offset_ = 0;
  std::uint64_t offset_ = 0;
  std::uint64_t line_number_ = 0;
  bool at_end_ = false;
};

}  // namespace cls::base
