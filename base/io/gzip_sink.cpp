// Gzip compression with zlib.
#include "base/io/gzip_sink.h"

#include <zlib.h>

#include <array>
#include <cassert>
#include <utility>

namespace cls::base {
namespace {

constexpr int kGzipWindowBits = 15 + 16;
constexpr int kMemoryLevel = 8;

}  // namespace

struct GzipSink::Stream {
  z_stream z = {};
  std::array<char, 64 * 1024> packed;
};

GzipSink::GzipSink(std::unique_ptr<ByteSink> inner, int level)
    : inner_(std::move(inner)), stream_(std::make_unique<Stream>()) {
  [[maybe_unused]] const int outcome = deflateInit2(&stream_->z, level, Z_DEFLATED, kGzipWindowBits,
                                                    kMemoryLevel, Z_DEFAULT_STRATEGY);
  assert(outcome == Z_OK);
}

GzipSink::~GzipSink() { [[maybe_unused]] const Result<void> closed = close(); }

void GzipSink::write(std::string_view bytes) { compress(bytes, false); }

Result<void> GzipSink::close() {
  if (stream_ != nullptr) {
    compress({}, true);
    deflateEnd(&stream_->z);
    stream_.reset();
  }
  return inner_->close();
}

void GzipSink::compress(std::string_view bytes, bool finish) {
  z_stream& z = stream_->z;
  // zlib does not write to next_in.
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  do {
    z.next_out = reinterpret_cast<Bytef*>(stream_->packed.data());
    z.avail_out = static_cast<uInt>(stream_->packed.size());
    deflate(&z, finish ? Z_FINISH : Z_NO_FLUSH);
    inner_->write({stream_->packed.data(), stream_->packed.size() - z.avail_out});
  } while (z.avail_out == 0);
}

Result<std::unique_ptr<ByteSink>> create_sink(const std::string& path) {
  TRY_INIT(auto file, FileSink::create(path));
  std::unique_ptr<ByteSink> sink = std::move(file);
  if (path.ends_with(".gz")) sink = std::make_unique<GzipSink>(std::move(sink));
  return sink;
}

}  // namespace cls::base
