// Decompresses with liblzma and libzstd.
#include "base/io/packed_sources.h"

#include <lzma.h>
#include <zstd.h>

#include <cstdint>
#include <utility>

namespace cls::base {
namespace {

constexpr std::size_t kBlock = 128 * 1024;

// The compressed bytes of `inner`, a block at a time.
class Blocks {
 public:
  Blocks(std::unique_ptr<ByteSource> inner, std::string first)
      : inner_(std::move(inner)), block_(std::move(first)) {}

  /// False at the end.
  bool next() {
    if (std::exchange(begun_, true)) {
      block_.resize(kBlock);
      block_.resize(inner_->read(block_.data(), kBlock));
    }
    return !block_.empty();
  }

  const std::string& block() const { return block_; }
  /// Why there are no more bytes where some are missing.
  std::string why_truncated(const char* format) const {
    return inner_->error().empty() ? std::string(format) + " data is truncated" : inner_->error();
  }

 private:
  std::unique_ptr<ByteSource> inner_;
  std::string block_;
  bool begun_ = false;
};

class XzSource : public ByteSource {
 public:
  XzSource(std::unique_ptr<ByteSource> inner, std::string first)
      : blocks_(std::move(inner), std::move(first)) {
    constexpr std::uint64_t kMemory = std::uint64_t{512} << 20;
    if (lzma_stream_decoder(&stream_, kMemory, LZMA_CONCATENATED) != LZMA_OK) {
      fail("cannot unpack xz: out of memory");
    }
  }
  ~XzSource() override { lzma_end(&stream_); }
  XzSource(const XzSource&) = delete;
  XzSource& operator=(const XzSource&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    stream_.next_out = reinterpret_cast<std::uint8_t*>(to);
    stream_.avail_out = size;
    while (stream_.avail_out == size && !ended_ && error().empty()) step();
    return size - stream_.avail_out;
  }

 private:
  void step() {
    lzma_action action = LZMA_RUN;
    if (stream_.avail_in == 0) {
      if (!blocks_.next()) action = LZMA_FINISH;
      stream_.next_in = reinterpret_cast<const std::uint8_t*>(blocks_.block().data());
      stream_.avail_in = blocks_.block().size();
    }

    const lzma_ret outcome = lzma_code(&stream_, action);
    ended_ = outcome == LZMA_STREAM_END;
    if (ended_ || outcome == LZMA_OK) return;
    if (outcome == LZMA_BUF_ERROR) return fail(blocks_.why_truncated("xz"));
    fail(outcome == LZMA_MEMLIMIT_ERROR ? "xz data needs more than 512 MB of memory"
                                        : "xz data is corrupt");
  }

  Blocks blocks_;
  lzma_stream stream_ = LZMA_STREAM_INIT;
  bool ended_ = false;
};

class ZstdSource : public ByteSource {
 public:
  ZstdSource(std::unique_ptr<ByteSource> inner, std::string first)
      : blocks_(std::move(inner), std::move(first)), stream_(ZSTD_createDStream()) {
    if (stream_ == nullptr) fail("cannot unpack zstd: out of memory");
  }
  ~ZstdSource() override { ZSTD_freeDStream(stream_); }
  ZstdSource(const ZstdSource&) = delete;
  ZstdSource& operator=(const ZstdSource&) = delete;

  std::size_t read(char* to, std::size_t size) override {
    ZSTD_outBuffer out{to, size, 0};
    while (out.pos == 0 && error().empty() && step(out)) {
    }
    return out.pos;
  }

 private:
  // Decompresses some bytes; false at the end.
  bool step(ZSTD_outBuffer& out) {
    if (in_.pos == in_.size) {
      if (!blocks_.next()) {
        if (within_frame_) fail(blocks_.why_truncated("zstd"));
        return false;
      }
      in_ = {blocks_.block().data(), blocks_.block().size(), 0};
    }

    const std::size_t outcome = ZSTD_decompressStream(stream_, &out, &in_);
    if (ZSTD_isError(outcome) != 0) fail("zstd data is corrupt");
    within_frame_ = outcome != 0;
    return true;
  }

  Blocks blocks_;
  ZSTD_DStream* stream_;
  ZSTD_inBuffer in_{nullptr, 0, 0};
  bool within_frame_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> unpack_xz(std::unique_ptr<ByteSource> inner, std::string first) {
  return std::make_unique<XzSource>(std::move(inner), std::move(first));
}

std::unique_ptr<ByteSource> unpack_zstd(std::unique_ptr<ByteSource> inner, std::string first) {
  return std::make_unique<ZstdSource>(std::move(inner), std::move(first));
}

}  // namespace cls::base
