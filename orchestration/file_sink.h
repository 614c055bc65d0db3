// A file that is written in order and remembers the first thing that went wrong.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "soccer/result.h"

namespace cls::orchestration {

/// Buffered output to one file. A failed write (disk full) is kept and told once by `error()`,
/// so that a match goes on and its result can say what is missing.
class FileSink {
 public:
  /// Creates or truncates the file; the error names it and the reason.
  static soccer::Result<FileSink> open(const std::filesystem::path& path);

  void write(std::string_view bytes);
  /// Hands everything to the operating system.
  void flush();

  /// The first failed write as one line, empty when all went well.
  const std::string& error() const { return error_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  FileSink(std::filesystem::path path, std::FILE* file);
  void note_failure();

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string error_;
};

/// Writes a whole file by way of a temporary one beside it and a rename, so that a reader never
/// sees half of it.
soccer::Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cls::orchestration
