// Serializes messages with map entries sorted by key.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace cls::proto {

/// The order of map entries in memory differs between processes. A Playmaker that iterates over an
/// unsorted map would play differently in each run. `size` is message.ByteSizeLong(), called just
/// before.
void write_with_sorted_maps(const google::protobuf::Message& message, std::uint8_t* bytes,
                            std::size_t size);

/// Replaces `bytes`, whose memory is reused.
void write_with_sorted_maps(const google::protobuf::Message& message, std::string& bytes);

}  // namespace cls::proto
