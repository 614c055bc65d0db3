// Which fields of a message are in use, by path.
#pragma once

#include <google/protobuf/message.h>

#include <set>
#include <string>

namespace cls::tests {

/// Adds the path of every field that is set in `message` and below, such as
/// "world_model.teammates.position.x"; elements of lists and maps count together.
void add_field_paths(const google::protobuf::Message& message, std::set<std::string>& paths,
                     const std::string& prefix = "");

/// Every path that a message of this type can have.
std::set<std::string> all_field_paths(const google::protobuf::Descriptor& type);

/// True if any number in `message` and below is infinite or not a number.
bool has_unreal_number(const google::protobuf::Message& message);

}  // namespace cls::tests
