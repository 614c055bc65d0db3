// Byte output: the interface, files, and strings in memory.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// Separates log formats from storage. write() reports no errors: close() returns the first one.
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  virtual void write(std::string_view bytes) = 0;

  /// Makes everything written so far visible to concurrent readers, if the sink supports it.
  virtual void flush() {}

  /// Passes everything written so far to the system. Returns the first error since creation.
  virtual Result<void> close() = 0;
};

/// Collects the bytes in memory.
class StringSink : public ByteSink {
 public:
  void write(std::string_view bytes) override { bytes_ += bytes; }
  Result<void> close() override { return {}; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// A new or truncated file, written in blocks of 64 KiB; "-" is standard output. Errors name the
/// file and the cause. close() may be called twice; the destructor closes and ignores errors.
class FileSink : public ByteSink {
 public:
  static Result<std::unique_ptr<FileSink>> create(const std::string& path);
  ~FileSink() override;

  void write(std::string_view bytes) override;
  void flush() override;
  Result<void> close() override;

 private:
  FileSink(std::string path, std::FILE* file);
  void fail();

  std::string path_;
  std::FILE* file_;
  std::string buffer_;
  std::string error_;
};

}  // namespace cls::base
