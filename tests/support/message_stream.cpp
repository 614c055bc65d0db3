// Reads length-delimited message streams.
#include "tests/support/message_stream.h"

#include <cstddef>
#include <stdexcept>

namespace cls::tests {

namespace {

std::size_t read_length(const std::string& stream, std::size_t& position) {
  std::size_t length = 0;
  for (int shift = 0; shift < 32; shift += 7) {
    if (position == stream.size()) throw std::runtime_error("message stream ends in a length");
    const auto byte = static_cast<unsigned char>(stream[position++]);
    length |= static_cast<std::size_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return length;
  }
  throw std::runtime_error("message stream has a length of more than 32 bits");
}

}  // namespace

std::vector<std::string> split_messages(const std::string& stream) {
  std::vector<std::string> messages;
  std::size_t position = 0;
  while (position < stream.size()) {
    const std::size_t length = read_length(stream, position);
    if (length > stream.size() - position) {
      throw std::runtime_error("message stream ends in a message");
    }
    messages.push_back(stream.substr(position, length));
    position += length;
  }
  return messages;
}

}  // namespace cls::tests
