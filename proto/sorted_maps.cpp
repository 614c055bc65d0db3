// Deterministic serialization.
#include "proto/sorted_maps.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

namespace cls::proto {

void write_with_sorted_maps(const google::protobuf::Message& message, std::uint8_t* bytes,
                            std::size_t size) {
  google::protobuf::io::ArrayOutputStream stream(bytes, static_cast<int>(size));
  google::protobuf::io::CodedOutputStream out(&stream);  // flushes in its destructor
  out.SetSerializationDeterministic(true);
  message.SerializeWithCachedSizes(&out);
}

void write_with_sorted_maps(const google::protobuf::Message& message, std::string& bytes) {
  bytes.resize(message.ByteSizeLong());
  write_with_sorted_maps(message, reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace cls::proto
