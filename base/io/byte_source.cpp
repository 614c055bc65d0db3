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

#include "base/io/packed_sources.h"
#include "base/io/standard_streams.h"
#include "base/text/byte_order_mark.h"

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

// Returns the bytes that were read for detection first.
class PlainSource : public ByteSource {
 public:
  PlainSource(std::unique_ptr<ByteSource> inner, std::string first)
      : inner_(std::move(inner)), first_(std::move(first)) {}

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

// At least `wanted` bytes of the stream, fewer only at its end, and what arrives with them.
std::string read_start(ByteSource& source, std::size_t wanted) {
  constexpr std::size_t kBlock = 512;
  std::string bytes(kBlock, '\0');
  std::size_t count = 0;
  while (count < wanted) {
    const std::size_t more = source.read(bytes.data() + count, bytes.size() - count);
    if (more == 0) break;
    count += more;
  }
  bytes.resize(count);
  return bytes;
}

constexpr std::string_view kGzipMagic = "\x1f\x8b";
constexpr std::size_t kLongestMagic = kXzMagic.size();

std::unique_ptr<ByteSource> unpacked(std::unique_ptr<ByteSource> inner, const std::string& first) {
  if (first.starts_with(kGzipMagic)) {
    return std::make_unique<InflatedSource>(std::move(inner), first);
  }
  if (first.starts_with(kXzMagic)) return unpack_xz(std::move(inner), first);
  if (first.starts_with(kZstdMagic)) return unpack_zstd(std::move(inner), first);
  return std::make_unique<PlainSource>(std::move(inner), first);
}

// Archives and compressions that cls does not read, with the command that unpacks them.
struct ForeignFormat {
  std::string_view magic;
  std::string_view name;
  std::string_view command;
  std::size_t offset = 0;  ///< of the magic
};

using namespace std::string_view_literals;
constexpr ForeignFormat kForeignFormats[] = {
    {"PK\x03\x04"sv, "a zip archive", "unzip"},
    {"BZh"sv, "compressed with bzip2", "bunzip2 -k"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive", "7z x"},
    {"Rar!"sv, "a rar archive", "unrar x"},
    {"\x04\x22\x4d\x18"sv, "compressed with lz4", "lz4 -d"},
    {"LZIP"sv, "compressed with lzip", "lzip -dk"},
    {"ustar"sv, "a tar archive", "tar -xf", 257},
};

// Why nothing can be read from a stream that begins like this; empty: it can.
std::string foreign_format(std::string_view start, const std::string& path) {
  for (const ForeignFormat& format : kForeignFormats) {
    if (start.size() < format.offset || !start.substr(format.offset).starts_with(format.magic)) {
      continue;
    }
    const std::string file = path == "-" ? "FILE" : "'" + path + "'";
    return "'" + path + "' is " + std::string(format.name) +
           "; unpack it first: " + std::string(format.command) + " " + file;
  }
  return {};
}

// The unpacked stream, and what it begins with.
struct Opened {
  std::unique_ptr<ByteSource> source;
  std::string start;
};

Opened open_packed(std::unique_ptr<ByteSource> inner) {
  const std::string first = read_start(*inner, kLongestMagic);
  auto source = unpacked(std::move(inner), first);
  std::string start = read_start(*source, kByteOrderMark.size());
  return {std::move(source), std::move(start)};
}

std::unique_ptr<ByteSource> whole(Opened opened) {
  remove_byte_order_mark(opened.start);
  return std::make_unique<PlainSource>(std::move(opened.source), std::move(opened.start));
}

Result<std::unique_ptr<ByteSource>> open_readable(std::unique_ptr<ByteSource> inner,
                                                  const std::string& path) {
  Opened opened = open_packed(std::move(inner));
  if (std::string foreign = foreign_format(opened.start, path); !foreign.empty()) {
    return Error{std::move(foreign)};
  }
  return whole(std::move(opened));
}

}  // namespace

std::size_t MemorySource::read(char* to, std::size_t size) {
  const std::size_t count = std::min(size, rest_.size());
  std::copy_n(rest_.data(), count, to);
  rest_.remove_prefix(count);
  return count;
}

std::unique_ptr<ByteSource> decompress(std::unique_ptr<ByteSource> inner) {
  return whole(open_packed(std::move(inner)));
}

Result<std::unique_ptr<ByteSource>> open_source(const std::string& path) {
  if (path == "-") {
    if (input_was_closed()) return Error{"standard input is closed"};
    return open_readable(std::make_unique<FileSource>(STDIN_FILENO), path);
  }

  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return Error{"cannot open '" + path + "': " + std::strerror(errno)};

  auto file = std::make_unique<FileSource>(descriptor);
  struct stat status = {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) {
    return Error{"cannot read '" + path + "': it is a folder"};
  }
  return open_readable(std::move(file), path);
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
