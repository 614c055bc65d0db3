// Messages of the interface in Thrift's binary protocol.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cls::proxy {

// The framework's Thrift interface has the structs, fields and numbers of its protobuf interface
// (docs/network.md), so messages are written and read by their descriptors: numbers are field ids,
// float is double, an enumeration is i32, a member of a oneof is an optional field.

/// Appends a call: method, sequence number, and `request` as its only argument. Fields that are not
/// set have their default, as Thrift's own writers do; members of a oneof are left out.
void append_thrift_call(std::string_view method, std::int32_t sequence,
                        const google::protobuf::Message& request, std::string& out);

/// A reply that has arrived completely, or not yet.
struct ThriftReply {
  enum class Kind : std::uint8_t {
    kIncomplete,
    kReply,      ///< the message is filled; empty if the method returned none
    kException,  ///< `error` is the server's text
    kInvalid,    ///< not a reply in Thrift's binary protocol; `error` says why
  };
  static constexpr std::int32_t kUnknownMethod = 1;

  Kind kind = Kind::kIncomplete;
  std::int32_t sequence = 0;
  std::size_t size = 0;             ///< bytes that it takes
  std::string error;                ///< one line
  std::int32_t exception_type = 0;  ///< of an exception: kUnknownMethod and others of Thrift
};

/// Reads a reply from the beginning of `bytes` into `message`. Unknown fields, and those of another
/// type, are skipped.
ThriftReply read_thrift_reply(std::string_view bytes, google::protobuf::Message& message);

}  // namespace cls::proxy
