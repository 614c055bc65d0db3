// Where the bytes of a log come from: a file, standard input or memory; plain or gzip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// The seam between storage and log formats: bytes in order, once.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// Puts up to `size` (> 0) bytes into `to` and returns how many; 0 at the end and after a
  /// problem, which problem() then tells.
  virtual std::size_t read(char* to, std::size_t size) = 0;

  /// Why the bytes ended before their end; empty while all is well.
  const std::string& problem() const { return problem_; }

  /// Size of the whole in bytes where it is known beforehand, else 0.
  virtual std::uint64_t size_hint() const { return 0; }

 protected:
  void fail(std::string why) { problem_ = std::move(why); }

 private:
  std::string problem_;
};

/// Bytes that are in memory already and stay there.
class MemorySource : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes) : rest_(bytes), size_(bytes.size()) {}
  std::size_t read(char* to, std::size_t size) override;
  std::uint64_t size_hint() const override { return size_; }

 private:
  std::string_view rest_;
  std::uint64_t size_;
};

/// What `inner` holds if it is gzip (one member or several, known by its first bytes, not by a
/// name), else its bytes as they are. Compressed bytes that end early or are damaged give what
/// could be unpacked, then a problem.
std::unique_ptr<ByteSource> unpacked(std::unique_ptr<ByteSource> inner);

/// The unpacked bytes of a file; "-" is standard input. The error names the path and the reason.
Result<std::unique_ptr<ByteSource>> open_source(const std::string& path);

/// Everything that is left; whether that is the whole, problem() of the source tells.
std::string read_all(ByteSource& source);

}  // namespace cls::base
