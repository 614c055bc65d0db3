// Recursive visitor of message fields.
#include "tests/proxy/messages/field_paths.h"

#include <google/protobuf/descriptor.pb.h>

#include <cmath>
#include <functional>

namespace cls::tests {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using Visitor = std::function<void(const Message&, const FieldDescriptor&, const std::string&)>;

// Calls `visit` for every set field. Map keys are skipped; map values count as the field.
void walk(const Message& message, const std::string& prefix, const Visitor& visit) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  const bool entry = message.GetDescriptor()->options().map_entry();

  for (const FieldDescriptor* field : fields) {
    if (entry && field->name() == "key") continue;
    const std::string path = entry            ? prefix
                             : prefix.empty() ? field->name()
                                              : prefix + "." + field->name();
    if (!entry) visit(message, *field, path);
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const auto& reflection = *message.GetReflection();
    if (!field->is_repeated()) {
      walk(reflection.GetMessage(message, field), path, visit);
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      walk(reflection.GetRepeatedMessage(message, field, i), path, visit);
    }
  }
}

void add_all(const Descriptor& type, const std::string& prefix, std::set<std::string>& paths) {
  const bool entry = type.options().map_entry();
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (entry && field.name() == "key") continue;
    const std::string path = entry            ? prefix
                             : prefix.empty() ? field.name()
                                              : prefix + "." + field.name();
    paths.insert(path);
    if (field.message_type() != nullptr) add_all(*field.message_type(), path, paths);
  }
}

}  // namespace

void add_field_paths(const Message& message, std::set<std::string>& paths,
                     const std::string& prefix) {
  walk(message, prefix, [&](const Message&, const FieldDescriptor&, const std::string& path) {
    paths.insert(path);
  });
}

std::set<std::string> all_field_paths(const Descriptor& type) {
  std::set<std::string> paths;
  add_all(type, "", paths);
  return paths;
}

bool has_unreal_number(const Message& message) {
  bool found = false;
  walk(message, "", [&](const Message& holder, const FieldDescriptor& field, const std::string&) {
    if (field.is_repeated()) return;
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT) {
      found |= !std::isfinite(holder.GetReflection()->GetFloat(holder, &field));
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      found |= !std::isfinite(holder.GetReflection()->GetDouble(holder, &field));
    }
  });
  return found;
}

}  // namespace cls::tests
