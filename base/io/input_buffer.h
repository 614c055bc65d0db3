// Lines and blocks out of a byte source, without copying each of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/byte_source.h"

namespace cls::base {

/// Views stay valid until the next call. Behind each view lie a line feed and 64 readable bytes,
/// so that a scanner may look ahead without checking for the end.
class InputBuffer {
 public:
  /// Longer lines are no log.
  static constexpr std::size_t kMaxLine = 1024 * 1024;

  explicit InputBuffer(ByteSource& source);

  enum class Line {
    kWhole,       ///< ended by a line feed
    kUnfinished,  ///< the last one, without a line feed
    kTooLong,     ///< `line` is its beginning; the rest is skipped
    kEnd,         ///< there is none
  };

  /// The next line, without its line feed.
  Line next_line(std::string_view& line);

  /// The next `size` (<= kMaxLine) bytes; fewer only at the end.
  std::string_view take(std::size_t size);

  /// The next bytes without consuming them, up to `size` (<= kMaxLine).
  std::string_view peek(std::size_t size);

  /// Position in the unpacked bytes of what was returned last, from 0.
  std::uint64_t offset() const { return offset_; }

  /// Number of the line that was returned last, from 1.
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
