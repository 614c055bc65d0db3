// Byte input: files, standard input and memory, plain or compressed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// Separates storage from log formats: a sequential stream of bytes.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Reads up to `size` (> 0) bytes into `to` and returns their number; 0 at the end of the stream
  /// and after an error.
  virtual std::size_t read(char* to, std::size_t size) = 0;

  /// Why the stream ended early; empty without an error.
  const std::string& error() const { return error_; }

  /// Total size in bytes if it is known in advance, otherwise 0.
  virtual std::uint64_t size_hint() const { return 0; }

 protected:
  void fail(std::string error) { error_ = std::move(error); }

 private:
  std::string error_;
};

/// Reads from memory, which must outlive the source.
class MemorySource : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : rest_(bytes), size_(bytes.size()) {}
  std::size_t read(char* to, std::size_t size) override;
  std::uint64_t size_hint() const override { return size_; }

 private:
  std::string_view rest_;
  std::uint64_t size_;
};

/// Decompresses `inner` if it is gzip, xz or zstd (detected by its first bytes; one or more
/// members), otherwise passes its bytes through, without a byte order mark at their begin.
/// Truncated or corrupt data yields the bytes decompressed before the error.
std::unique_ptr<ByteSource> decompress(std::unique_ptr<ByteSource> inner);

/// The decompressed bytes of a file (see above); "-" is standard input. The error names the path
/// and the cause, for archives the command that unpacks them.
Result<std::unique_ptr<ByteSource>> open_source(const std::string& path);

/// Reads to the end of the stream. Check `source.error()` afterwards.
std::string read_all(ByteSource& source);

}  // namespace cls::base
