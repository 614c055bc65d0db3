// Keys are checked here, with place and suggestion; values by protobuf.
#include "mock-server/script/message_json.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace cls::mock_server {
namespace {

using base::Result;
using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

Result<void> check_keys(const base::JsonValue& json, const Descriptor& type);

Result<void> check_element(const base::JsonValue& json, const FieldDescriptor& field) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    return check_keys(json, *field.message_type());
  }
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM && json.is_string()) {
    std::vector<std::string_view> names;
    for (int i = 0; i < field.enum_type()->value_count(); ++i) {
      names.push_back(field.enum_type()->value(i)->name());
    }
    if (const auto word = json.word(names); !word) return word.error();
  }
  return {};
}

Result<void> check_field(const base::JsonValue& json, const FieldDescriptor& field) {
  if (field.is_map()) {
    if (!json.is_object()) return json.error("must be an object");
    const FieldDescriptor& value = *field.message_type()->field(1);
    for (const std::string& key : json.keys()) {
      if (const auto good = check_element(json[key], value); !good) return good;
    }
    return {};
  }
  if (!field.is_repeated()) return check_element(json, field);
  if (!json.is_list()) return json.error("must be a list");
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (const auto good = check_element(json[i], field); !good) return good;
  }
  return {};
}

Result<void> check_keys(const base::JsonValue& json, const Descriptor& type) {
  if (!json.is_object()) {
    return json.error(fmt::format("must be an object with the fields of {}", type.name()));
  }
  std::vector<std::string_view> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  for (const std::string& key : json.keys()) {
    const FieldDescriptor* field = type.FindFieldByName(key);
    for (int i = 0; field == nullptr && i < type.field_count(); ++i) {
      if (type.field(i)->json_name() == key) field = type.field(i);
    }
    if (field == nullptr) {
      return json[key].error(
          fmt::format("{} has no field '{}'{}", type.name(), key, base::did_you_mean(key, names)));
    }
    if (const auto good = check_field(json[key], *field); !good) return good;
  }
  return {};
}

}  // namespace

Result<void> read_message(const base::JsonValue& json, google::protobuf::Message& message) {
  if (const auto keys = check_keys(json, *message.GetDescriptor()); !keys) return keys;
  const auto status = google::protobuf::util::JsonStringToMessage(json.json().dump(), &message);
  if (!status.ok()) return json.error(std::string(status.message()));
  return {};
}

}  // namespace cls::mock_server
