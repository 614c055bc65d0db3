// libFuzzer target: arbitrary bytes as a compressed datagram.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "simulator/server/message_compression.h"
#include "tests/fuzz/require.h"

using cls::tests::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMaxSize = 8192;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  cls::simulator::MessageCompression zlib(size % 10);
  std::string message;
  zlib.decompress(bytes, kMaxSize, message);
  require(message.size() <= kMaxSize);
  // What a server sends, a client reads, also right after an invalid datagram.
  const std::string sent(bytes.substr(0, kMaxSize - 1));
  const std::string compressed(zlib.compress(sent));
  require(zlib.decompress(compressed, kMaxSize, message) && message == sent);
  return 0;
}
