// zlib around single messages.
#include "simulator/server/message_compression.h"

#include <zlib.h>

#include <cassert>

namespace cls::simulator {

struct MessageCompression::Streams {
  z_stream out{};
  z_stream in{};
  std::string packed;
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

std::string_view MessageCompression::packed(std::string_view message) {
  z_stream& out = streams_->out;
  std::string& packed = streams_->packed;
  deflateReset(&out);
  constexpr std::size_t kFlush = 16;  // what a flush adds at most
  packed.resize(deflateBound(&out, static_cast<uLong>(message.size())) + kFlush);
  out.next_in = bytes(message.data());
  out.avail_in = static_cast<uInt>(message.size());
  out.next_out = bytes(packed.data());
  out.avail_out = static_cast<uInt>(packed.size());
  deflate(&out, Z_SYNC_FLUSH);
  return std::string_view(packed).substr(0, packed.size() - out.avail_out);
}

bool MessageCompression::unpack(std::string_view datagram, std::size_t longest,
                                std::string& message) {
  z_stream& in = streams_->in;
  inflateReset(&in);
  message.resize(longest);
  in.next_in = bytes(datagram.data());
  in.avail_in = static_cast<uInt>(datagram.size());
  in.next_out = bytes(message.data());
  in.avail_out = static_cast<uInt>(message.size());
  const int result = inflate(&in, Z_SYNC_FLUSH);
  message.resize(longest - in.avail_out);
  return (result == Z_OK || result == Z_STREAM_END) && in.avail_in == 0;
}

}  // namespace cls::simulator
