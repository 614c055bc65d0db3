// Buffered output files.
#include "base/io/byte_sink.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace cls::base {
namespace {

constexpr std::size_t kBlock = 64 * 1024;

}  // namespace

Result<std::unique_ptr<FileSink>> FileSink::create(const std::string& path) {
  std::FILE* file =
      path == "-" ? ::fdopen(::dup(STDOUT_FILENO), "wb") : std::fopen(path.c_str(), "wbe");
  if (file == nullptr) return Error{"cannot create '" + path + "': " + std::strerror(errno)};

  std::setvbuf(file, nullptr, _IONBF, 0);
  return std::unique_ptr<FileSink>(new FileSink(path, file));
}

FileSink::FileSink(std::string path, std::FILE* file) : path_(std::move(path)), file_(file) {
  buffer_.reserve(kBlock + kBlock / 4);
}

FileSink::~FileSink() { [[maybe_unused]] const Result<void> closed = close(); }

void FileSink::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBlock) flush();
}

Result<void> FileSink::close() {
  if (file_ != nullptr) {
    flush();
    if (std::fclose(file_) != 0) fail();
    file_ = nullptr;
  }
  if (error_.empty()) return {};
  return Error{error_};
}

void FileSink::flush() {
  if (file_ != nullptr && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) {
    fail();
  }
  buffer_.clear();
}

void FileSink::fail() {
  if (error_.empty()) error_ = "cannot write '" + path_ + "': " + std::strerror(errno);
}

}  // namespace cls::base
