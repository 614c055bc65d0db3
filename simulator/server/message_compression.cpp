// Compresses single messages with zlib.
#include "simulator/server/message_compression.h"

#include <zlib.h>

#include <cassert>

namespace cls::simulator {

struct MessageCompression::Streams {
  z_stream out{};
  z_stream in{};
  std::string compressed;
};

namespace {

Bytef* bytes(const char* at) { return reinterpret_cast<Bytef*>(const_cast<char*>(at)); }

}  // namespace

MessageCompression::MessageCompression(int level) : streams_(std::make_unique<Streams>()) {
  [[maybe_unused]] int ready = deflateInit(&streams_->out, level);
  assert(ready == Z_OK);
  ready = inflateInit(&streams_->in);
  assert(ready == Z_OK);
}

MessageCompression::~MessageCompression() {
  deflateEnd(&streams_->out);
  inflateEnd(&streams_->in);
}

std::string_view MessageCompression::compress(std::string_view message) {
  z_stream& out = streams_->out;
  std::string& compressed = streams_->compressed;
  deflateReset(&out);
  constexpr std::size_t kFlush = 16;  // maximum added by a flush
  compressed.resize(deflateBound(&out, static_cast<uLong>(message.size())) + kFlush);
  out.next_in = bytes(message.data());
  out.avail_in = static_cast<uInt>(message.size());
  out.next_out = bytes(compressed.data());
  out.avail_out = static_cast<uInt>(compressed.size());
  deflate(&out, Z_SYNC_FLUSH);
  return std::string_view(compressed).substr(0, compressed.size() - out.avail_out);
}

bool MessageCompression::decompress(std::string_view datagram, std::size_t max_size,
                                    std::string& message) {
  z_stream& in = streams_->in;
  inflateReset(&in);
  message.resize(max_size);
  in.next_in = bytes(datagram.data());
  in.avail_in = static_cast<uInt>(datagram.size());
  in.next_out = bytes(message.data());
  in.avail_out = static_cast<uInt>(message.size());
  const int result = inflate(&in, Z_SYNC_FLUSH);
  message.resize(max_size - in.avail_out);
  return (result == Z_OK || result == Z_STREAM_END) && in.avail_in == 0;
}

}  // namespace cls::simulator
