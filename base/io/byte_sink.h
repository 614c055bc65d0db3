// Where the bytes of a log go: a file, or a string in memory.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// The seam between log formats and storage. Writing never fails at the call; the first error is
/// kept and told by close().
class ByteSink {
 public:
  virtual ~ByteSink() = default;

  virtual void write(std::string_view bytes) = 0;

  /// Lets who reads along see everything written so far, where that costs nothing but time. An
  /// error is told by close().
  virtual void flush() {}

  /// Everything written so far is out of our hands afterwards. The first error since the start.
  virtual Result<void> close() = 0;
};

/// Keeps the bytes in memory.
class StringSink : public ByteSink {
 public:
  void write(std::string_view bytes) override { bytes_ += bytes; }
  Result<void> close() override { return {}; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// A new file (an old one of that name is emptied), written in blocks of 64 KiB; "-" is standard
/// output. An error names the file and the reason. Closing twice is allowed; the destructor closes
/// and drops the error.
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
