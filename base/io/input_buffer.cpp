// A buffer that slides over the source and grows for long lines.
#include "base/io/input_buffer.h"

#include <algorithm>
#include <cstring>

#include "base/index.h"

namespace cls::base {
namespace {

constexpr std::size_t kBlock = 256 * 1024;  // fits into the L2 cache
constexpr std::size_t kLookAhead = 64;
constexpr std::size_t kLongLinePrefix = 1024;

// Cuts off the CR of CR LF. A line feed takes its place, for scanners that read on.
std::string_view without_carriage_return(char* start, std::size_t length) {
  if (length == 0 || start[length - 1] != '\r') return {start, length};
  start[length - 1] = '\n';
  return {start, length - 1};
}

}  // namespace

InputBuffer::InputBuffer(ByteSource& source) : source_(source) {
  bytes_.resize(kBlock + kLookAhead, '\n');
}

bool InputBuffer::fill(std::size_t wanted) {
  if (available() >= wanted) return true;

  if (begin_ > 0) {
    std::memmove(bytes_.data(), bytes_.data() + begin_, available());
    end_ -= begin_;
    begin_ = 0;
  }

  if (bytes_.size() < wanted + kLookAhead) bytes_.resize(wanted + kLookAhead);
  while (!at_end_ && end_ < wanted) {
    const std::size_t count = source_.read(bytes_.data() + end_, bytes_.size() - kLookAhead - end_);
    end_ += count;
    at_end_ = count == 0;
  }

  std::fill_n(bytes_.begin() + static_cast<std::ptrdiff_t>(end_), kLookAhead, '\n');
  return available() >= wanted;
}

void InputBuffer::advance(std::size_t size) {
  begin_ += size;
  begin_offset_ += size;
}

InputBuffer::Line InputBuffer::next_line(std::string_view& line) {
  offset_ = begin_offset_;
  std::size_t searched = 0;
  for (;;) {
    const char* start = bytes_.data() + begin_;
    const void* found = std::memchr(start + searched, '\n', available() - searched);
    if (found != nullptr) {
      const std::size_t length = index(static_cast<const char*>(found) - start);
      line = without_carriage_return(bytes_.data() + begin_, length);
      advance(length + 1);
      ++line_number_;
      return Line::kWhole;
    }

    searched = available();
    if (searched >= kMaxLine) {
      ++line_number_;
      long_line_.assign(start, kLongLinePrefix);
      line = long_line_;
      skip_line();
      return Line::kTooLong;
    }

    // Larger blocks for long lines, but no more than what the source has now: a line of a growing
    // file is returned when it is complete.
    const std::size_t block = std::min(std::max(searched * 2, kBlock), kMaxLine);
    if (bytes_.size() < block + kLookAhead) bytes_.resize(block + kLookAhead);
    if (fill(searched + 1)) continue;
    if (searched == 0) return Line::kEnd;

    ++line_number_;
    line = without_carriage_return(bytes_.data() + begin_, searched);
    advance(searched);
    return Line::kUnfinished;
  }
}

void InputBuffer::skip_line() {
  do {
    const void* found = std::memchr(bytes_.data() + begin_, '\n', available());
    if (found != nullptr) {
      return advance(index(static_cast<const char*>(found) - bytes_.data()) + 1 - begin_);
    }
    advance(available());
  } while (fill(1));
}

std::string_view InputBuffer::take(std::size_t size) {
  const std::string_view bytes = peek(size);
  offset_ = begin_offset_;
  advance(bytes.size());
  return bytes;
}

std::string_view InputBuffer::peek(std::size_t size) {
  fill(size);
  return {bytes_.data() + begin_, std::min(size, available())};
}

}  // namespace cls::base
