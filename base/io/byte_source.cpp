// File input and gzip decompression.
#include "base/io/byte_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace cls::base {
namespace {

// Uses read() instead of mmap(): a server may truncate a log while it is read, which is a short
// read here and a bus error with mmap(). The speed is the same (docs/formats/rcg.md).
class FileSource : public ByteSource {
 public:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {}
  ~FileSource() override {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    for (;;) {
      const ssize_t count = ::read(descriptor_, to, size);
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno == EINTR) continue;
      fail(std::strerror(errno));
      return 0;
    }
  }

  std::uint64_t size_hint() const override {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::uint64_t>(status.st_size);
  }

 private:
  int descriptor_;
};

constexpr int kGzipWindowBits = 15 + 16;

class InflatedSource : public ByteSource {
 public:
  InflatedSource(std::unique_ptr<ByteSource> inner, std::string_view first)
      : inner_(std::move(inner)) {
    std::ranges::copy(first, packed_.begin());
    stream_.next_in = packed_.data();
    stream_.avail_in = static_cast<uInt>(first.size());
    usable_ = inflateInit2(&stream_, kGzipWindowBits) == Z_OK;
    if (!usable_) fail("cannot unpack: out of memory");
  }
  ~InflatedSource() override {
    if (usable_) inflateEnd(&stream_);
  }
  InflatedSource(const InflatedSource&) = delete;
  InflatedSource& operator=(const InflatedSource&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    if (!usable_ || !error().empty()) return 0;

    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(std::min(size, std::size_t{1} << 30));
    const uInt wanted = stream_.avail_out;
    while (stream_.avail_out == wanted && step()) {
    }
    return wanted - stream_.avail_out;
  }

 private:
  // Calls inflate() once; false at the end of the stream and after an error.
  bool step() {
    if (stream_.avail_in == 0 && !refill()) {
      if (within_member_)
        fail(inner_->error().empty() ? "gzip data is truncated" : inner_->error());
      return false;
    }

    within_member_ = true;
    const int outcome = inflate(&stream_, Z_NO_FLUSH);
    if (outcome == Z_STREAM_END) {
      within_member_ = false;
      return start_next_member();
    }

    if (outcome == Z_OK || outcome == Z_BUF_ERROR) return true;
    fail(std::string("gzip data is corrupt: ") + (stream_.msg != nullptr ? stream_.msg : "?"));
    return false;
  }

  bool refill() {
    const std::size_t count = inner_->read(reinterpret_cast<char*>(packed_.data()), packed_.size());
    stream_.next_in = packed_.data();
    stream_.avail_in = static_cast<uInt>(count);
    return count > 0;
  }

  // Zero bytes may follow the last member.
  bool start_next_member() {
    for (;;) {
      if (stream_.avail_in == 0 && !refill()) {
        if (!inner_->error().empty()) fail(inner_->error());
        return stream_.avail_out == 0;
      }
      if (*stream_.next_in != 0) break;
      ++stream_.next_in;
      --stream_.avail_in;
    }
    return inflateReset(&stream_) == Z_OK;
  }

  std::unique_ptr<ByteSource> inner_;
  std::array<Bytef, 128 * 1024> packed_;
  z_stream stream_ = {};
  bool usable_ = false;
  bool within_member_ = true;
};

// Returns the bytes that were read for gzip detection first.
class PlainSource : public ByteSource {
 public:
  PlainSource(std::unique_ptr<ByteSource> inner, std::string_view first)
      : inner_(std::move(inner)), first_(first) {}

  std::size_t read(char* to, std::size_t size) override {
    if (!first_.empty()) {
      const std::size_t count = std::min(size, first_.size());
      std::memcpy(to, first_.data(), count);
      first_.erase(0, count);
      return count;
    }

    const std::size_t count = inner_->read(to, size);
    if (count == 0 && !inner_->error().empty()) fail(inner_->error());
    return count;
  }

  std::uint64_t size_hint() const override { return inner_->size_hint(); }

 private:
  std::unique_ptr<ByteSource> inner_;
  std::string first_;
};

constexpr std::string_view kGzipMagic = "\x1f\x8b";

}  // namespace

std::size_t MemorySource::read(char* to, std::size_t size) {
  const std::size_t count = std::min(size, rest_.size());
  std::copy_n(rest_.data(), count, to);
  rest_.remove_prefix(count);
  return count;
}

std::unique_ptr<ByteSource> decompress(std::unique_ptr<ByteSource> inner) {
  std::array<char, 2> start;
  std::size_t count = 0;
  while (count < start.size()) {
    const std::size_t more = inner->read(start.data() + count, start.size() - count);
    if (more == 0) break;
    count += more;
  }

  const std::string_view first(start.data(), count);
  if (first == kGzipMagic) return std::make_unique<InflatedSource>(std::move(inner), first);
  return std::make_unique<PlainSource>(std::move(inner), first);
}

Result<std::unique_ptr<ByteSource>> open_source(const std::string& path) {
  if (path == "-") return decompress(std::make_unique<FileSource>(STDIN_FILENO));

  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return Error{"cannot open '" + path + "': " + std::strerror(errno)};

  auto file = std::make_unique<FileSource>(descriptor);
  struct stat status = {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) {
    return Error{"cannot read '" + path + "': it is a folder"};
  }
  return decompress(std::move(file));
}

std::string read_all(ByteSource& source) {
  constexpr std::size_t kChunk = 1 << 16;
  std::string bytes;
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kChunk);
    const std::size_t count = source.read(bytes.data() + size, kChunk);
    bytes.resize(size + count);
    if (count == 0) return bytes;
  }
}

}  // namespace cls::base
