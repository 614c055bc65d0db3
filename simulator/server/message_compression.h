// Compressed datagrams, as clients may ask for them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace cls::simulator {

/// Each message is the beginning of a zlib stream of its own, flushed but not ended (protocol 1.7).
class MessageCompression {
 public:
  explicit MessageCompression(int level);
  ~MessageCompression();

  /// The view holds until the next call.
  std::string_view packed(std::string_view message);

  /// False if it is no such beginning, or longer than `longest` when unpacked.
  bool unpack(std::string_view datagram, std::size_t longest, std::string& message);

 private:
  struct Streams;
  std::unique_ptr<Streams> streams_;
};

}  // namespace cls::simulator
