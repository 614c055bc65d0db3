// Files that remember their first error.
#include "orchestration/file_sink.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace cls::orchestration {

using soccer::Error;
using soccer::Result;

FileSink::FileSink(std::filesystem::path path, std::FILE* file)
    : path_(std::move(path)), file_(file) {}

Result<FileSink> FileSink::open(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbe");
  if (file == nullptr) {
    return Error{fmt::format("cannot create {}: {}", path.string(), std::strerror(errno))};
  }
  return FileSink(path, file);
}

void FileSink::note_failure() {
  if (!error_.empty()) return;
  error_ = fmt::format("writing {} failed: {}", path_.string(), std::strerror(errno));
}

void FileSink::write(std::string_view bytes) {
  if (!error_.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) note_failure();
}

void FileSink::flush() {
  if (std::fflush(file_.get()) != 0) note_failure();
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  {
    auto file = FileSink::open(temporary);
    if (!file) return Error{file.error()};
    file->write(bytes);
    file->flush();
    if (!file->error().empty()) return Error{file->error()};
  }
  std::error_code code;
  std::filesystem::rename(temporary, path, code);
  if (code) return Error{fmt::format("cannot create {}: {}", path.string(), code.message())};
  return {};
}

}  // namespace cls::orchestration
