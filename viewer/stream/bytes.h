// Bytes of chunks: variable-length integers, strings, single-precision reals
// (docs/formats/view.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cls::viewer {

/// Varints are below this: five bytes of seven bits.
constexpr std::uint64_t kVarintEnd = std::uint64_t{1} << 35;

/// `value` must be below kVarintEnd.
void append_varint(std::uint64_t value, std::string& out);
/// The magnitude of `value` must be below kVarintEnd / 2.
void append_zigzag(std::int64_t value, std::string& out);
void append_string(std::string_view text, std::string& out);
void append_float(float value, std::string& out);

/// Reads from the start of `bytes`. After the first failure everything else fails too, so callers
/// may check good() once at the end; failed reads return 0.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte();
  std::uint64_t varint();
  std::int64_t zigzag();
  /// The next `size` bytes; empty on failure.
  std::string_view take(std::uint64_t size);
  std::string_view string() { return take(varint()); }
  float real();

  void fail() {
    good_ = false;
    rest_ = {};
  }
  bool good() const { return good_; }
  bool at_end() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  bool good_ = true;
};

}  // namespace cls::viewer
