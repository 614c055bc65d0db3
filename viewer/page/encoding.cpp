// Base64 and hashes with OpenSSL, gzip with the sinks and sources of base.
#include "viewer/page/encoding.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cassert>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>

#include "base/index.h"
#include "base/io/byte_source.h"
#include "base/io/gzip_sink.h"

namespace cls::viewer {
namespace {

constexpr int kNoDigit = -1;

int digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : kNoDigit;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  const int done =
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  assert(done == 1);
  return {reinterpret_cast<const char*>(digest.data()), size};
}

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(base::index(length));
  return text;
}

base::Result<std::string> from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);

  unsigned buffer = 0;
  int bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_space(text[i]) || text[i] == '=') continue;
    const int digit = digit_of(text[i]);
    if (digit == kNoDigit) {
      return base::Error{"no base64 at character " + std::to_string(i + 1) + " of the match"};
    }

    buffer = buffer << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(buffer >> bits & 0xFF);
  }
  return bytes;
}

std::string csp_hash(std::string_view text) { return "'sha256-" + base64(sha256(text)) + "'"; }

std::string sha256_hex(std::string_view bytes) {
  std::string text;
  for (const char byte : sha256(bytes)) {
    fmt::format_to(std::back_inserter(text), "{:02x}", static_cast<unsigned char>(byte));
  }
  return text;
}

std::string gzip(std::string_view bytes) {
  auto packed = std::make_unique<base::StringSink>();
  const std::string& result = packed->bytes();
  base::GzipSink sink(std::move(packed));
  sink.write(bytes);
  std::ignore = sink.close();  // in memory
  return result;
}

base::Result<std::string> gunzip(std::string_view bytes, std::size_t max_size) {
  if (!bytes.starts_with("\x1f\x8b")) return base::Error{"the match is not gzip"};

  const auto source = base::decompress(std::make_unique<base::MemorySource>(bytes));
  std::string unpacked;
  std::array<char, 64 * 1024> block;
  while (const std::size_t size = source->read(block.data(), block.size())) {
    unpacked.append(block.data(), size);
    if (unpacked.size() > max_size) return base::Error{"the match is too large"};
  }

  if (!source->error().empty()) {
    return base::Error{"the match does not inflate: " + source->error()};
  }
  return unpacked;
}

}  // namespace cls::viewer
