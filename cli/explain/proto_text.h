// The messages and enumerations of a .proto file with their comments.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::cli {

/// A field of a message, or a value of an enumeration (without type).
struct ProtoField {
  std::string type;  ///< "float", "repeated Player", "map<int32, Player>"
  std::string name;
  int number = 0;
  std::string comment;
};

struct ProtoBlock {
  bool is_enum = false;
  std::string name;
  std::string comment;
  std::vector<ProtoField> fields;
};

/// Reads text in the style of proto/: one field per line, a comment above or behind it, no nested
/// messages. Descriptors at run time have no comments.
std::vector<ProtoBlock> read_proto(std::string_view text);

}  // namespace cls::cli
