// Compression of datagrams, which clients may request.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cls::simulator {

/// Each message is the start of its own zlib stream, flushed but not finished
/// (docs/spec/server-protocol.md 1.7).
class MessageCompression {
 public:
  explicit MessageCompression(int level);
  ~MessageCompression();

  /// The view is valid until the next call.
  std::string_view compress(std::string_view message);

  /// Returns false if the datagram is invalid or decompresses to more than `max_size` bytes.
  bool decompress(std::string_view datagram, std::size_t max_size, std::string& message);

 private:
  struct Streams;
  std::unique_ptr<Streams> streams_;
};

}  // namespace cls::simulator
