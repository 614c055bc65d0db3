// Recorded length-delimited protobuf messages.
#pragma once

#include <string>
#include <vector>

namespace cls::tests {

/// The messages of a stream in which each is preceded by its length in bytes as a base-128 varint
/// (what protobuf calls delimited). Throws std::runtime_error when the stream ends within one.
std::vector<std::string> split_messages(const std::string& stream);

}  // namespace cls::tests
