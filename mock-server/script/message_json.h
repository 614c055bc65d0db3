// Messages of the wire written as JSON, by protobuf's own mapping, with mistakes told by their
// place.
#pragma once

#include <google/protobuf/message.h>

#include "base/result.h"
#include "base/text/json_text.h"

namespace cls::mock_server {

/// Fills the empty `message`. Field names as in the .proto file or in lowerCamelCase; enum values
/// by name. An unknown field is an error that suggests one.
base::Result<void> read_message(const base::JsonValue& json, google::protobuf::Message& message);

}  // namespace cls::mock_server
