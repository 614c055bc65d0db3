// Writes and reads variable-length integers.
#include "viewer/stream/bytes.h"

#include <bit>
#include <cassert>

namespace cls::viewer {
namespace {

constexpr int kMaxVarintBytes = 5;

}  // namespace

void append_varint(std::uint64_t value, std::string& out) {
  assert(value < kVarintEnd);
  for (; value >= 0x80; value >>= 7) out += static_cast<char>(value | 0x80);
  out += static_cast<char>(value);
}

void append_zigzag(std::int64_t value, std::string& out) {
  const std::uint64_t sign = value < 0 ? ~std::uint64_t{0} : 0;
  append_varint(static_cast<std::uint64_t>(value) << 1 ^ sign, out);
}

void append_string(std::string_view text, std::string& out) {
  append_varint(text.size(), out);
  out += text;
}

void append_float(float value, std::string& out) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(bits >> shift & 0xFF);
}

std::uint8_t ByteReader::byte() {
  if (rest_.empty()) {
    fail();
    return 0;
  }
  const auto value = static_cast<std::uint8_t>(rest_.front());
  rest_.remove_prefix(1);
  return value;
}

std::uint64_t ByteReader::varint() {
  std::uint64_t value = 0;
  for (int i = 0; i < kMaxVarintBytes; ++i) {
    const std::uint8_t next = byte();
    value |= std::uint64_t{next & 0x7FU} << (7 * i);
    if (next < 0x80) return good_ ? value : 0;
  }
  fail();
  return 0;
}

std::int64_t ByteReader::zigzag() {
  const std::uint64_t value = varint();
  const auto half = static_cast<std::int64_t>(value >> 1);
  return (value & 1) != 0 ? -half - 1 : half;
}

std::string_view ByteReader::take(std::uint64_t size) {
  if (size > rest_.size()) {
    fail();
    return {};
  }
  const std::string_view bytes = rest_.substr(0, static_cast<std::size_t>(size));
  rest_.remove_prefix(bytes.size());
  return bytes;
}

float ByteReader::real() {
  std::uint32_t bits = 0;
  for (int shift = 0; shift < 32; shift += 8) bits |= std::uint32_t{byte()} << shift;
  return good_ ? std::bit_cast<float>(bits) : 0.0F;
}

}  // namespace cls::viewer
