// Resolving paths by reflection.
#include "mock-server/script/field_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text/split.h"
#include "base/text/suggestion.h"

namespace cls::mock_server {
namespace {

using base::Error;
using base::Result;
using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

const FieldDescriptor* find_field(const Descriptor& type, std::string_view name) {
  for (int i = 0; i < type.field_count(); ++i) {
    if (type.field(i)->name() == name || type.field(i)->json_name() == name) return type.field(i);
  }
  return nullptr;
}

Error no_such_field(const Descriptor& type, std::string_view name) {
  std::vector<std::string_view> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return Error{
      fmt::format("{} has no field '{}'{}", type.name(), name, base::did_you_mean(name, names))};
}

const FieldDescriptor* map_value(const FieldDescriptor& field) {
  return field.message_type()->field(1);
}

// The kind of what a field (or an element of it) holds.
ValueKind kind_of(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      return {ValueKind::Kind::kBool, nullptr};
    case FieldDescriptor::CPPTYPE_STRING:
      return {ValueKind::Kind::kString, nullptr};
    case FieldDescriptor::CPPTYPE_ENUM:
      return {ValueKind::Kind::kEnum, field.enum_type()};
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return {ValueKind::Kind::kMessage, nullptr};
    default:
      return {};
  }
}

// A scalar of `message`, or element `index` of a list of scalars.
Value scalar(const Message& message, const FieldDescriptor& field, int index) {
  const Reflection& reflection = *message.GetReflection();
  const bool list = field.is_repeated();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      return list ? reflection.GetRepeatedBool(message, &field, index)
                  : reflection.GetBool(message, &field);
    case FieldDescriptor::CPPTYPE_STRING:
      return list ? reflection.GetRepeatedString(message, &field, index)
                  : reflection.GetString(message, &field);
    case FieldDescriptor::CPPTYPE_ENUM: {
      const int number = list ? reflection.GetRepeatedEnumValue(message, &field, index)
                              : reflection.GetEnumValue(message, &field);
      const auto* named = field.enum_type()->FindValueByNumber(number);
      return named == nullptr ? std::to_string(number) : named->name();
    }
    case FieldDescriptor::CPPTYPE_INT32:
      return static_cast<double>(list ? reflection.GetRepeatedInt32(message, &field, index)
                                      : reflection.GetInt32(message, &field));
    case FieldDescriptor::CPPTYPE_INT64:
      return static_cast<double>(list ? reflection.GetRepeatedInt64(message, &field, index)
                                      : reflection.GetInt64(message, &field));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return static_cast<double>(list ? reflection.GetRepeatedFloat(message, &field, index)
                                      : reflection.GetFloat(message, &field));
    default:
      return list ? reflection.GetRepeatedDouble(message, &field, index)
                  : reflection.GetDouble(message, &field);
  }
}

}  // namespace

Result<FieldPath::Step> FieldPath::compile_step(const Descriptor& type, std::string_view name,
                                                std::string_view selector) {
  Step step;
  step.field = find_field(type, name);
  if (step.field == nullptr) return no_such_field(type, name);
  if (!step.field->is_repeated()) return step;

  if (selector == "*") {
    step.select = Select::kAny;
  } else if (selector == "size") {
    step.select = Select::kSize;
  } else {
    step.select = step.field->is_map() ? Select::kKey : Select::kIndex;
    const auto [end, code] =
        std::from_chars(selector.data(), selector.data() + selector.size(), step.number);
    const bool whole = !selector.empty() && end == selector.data() + selector.size();
    if (!whole || code != std::errc{} || (step.select == Select::kIndex && step.number < 0)) {
      return Error{fmt::format("after '{}' comes {}, '*' or 'size', not '{}'", name,
                               step.field->is_map() ? "a key" : "an index from 0", selector)};
    }
  }
  return step;
}

Result<FieldPath> FieldPath::compile(const Descriptor& root, std::string_view text) {
  std::vector<std::string_view> names = base::split(text, '.');
  const Descriptor* type = &root;
  const FieldDescriptor* world = find_field(root, "world_model");
  if (world != nullptr && find_field(root, names.front()) == nullptr &&
      find_field(*world->message_type(), names.front()) != nullptr) {
    names.insert(names.begin(), "world_model");
  }

  FieldPath path;
  path.text_ = text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (type == nullptr) return Error{fmt::format("'{}' has no fields", names[i - 1])};
    TRY_INIT(const auto step,
             compile_step(*type, names[i], i + 1 < names.size() ? names[i + 1] : ""));
    path.steps_.push_back(step);

    const FieldDescriptor& field = step.field->is_map() ? *map_value(*step.field) : *step.field;
    path.kind_ = step.select == Select::kSize ? ValueKind{} : kind_of(field);
    type = path.kind_.kind == ValueKind::Kind::kMessage ? field.message_type() : nullptr;
    if (step.select != Select::kField) ++i;
  }
  return path;
}

void FieldPath::collect_elements(const Message& message, std::size_t at, bool& present,
                                 std::vector<Value>& values) const {
  const Step& step = steps_[at];
  const Reflection& reflection = *message.GetReflection();
  const int size = reflection.FieldSize(message, step.field);
  const bool last = at + 1 == steps_.size();

  for (int i = 0; i < size; ++i) {
    if (step.select == Select::kIndex && i != step.number) continue;
    if (step.field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
      present = true;
      values.push_back(scalar(message, *step.field, i));
      continue;
    }

    const Message* element = &reflection.GetRepeatedMessage(message, step.field, i);
    if (step.field->is_map()) {
      const FieldDescriptor& key = *step.field->message_type()->field(0);
      if (step.select == Select::kKey &&
          scalar(*element, key, 0) != Value(static_cast<double>(step.number))) {
        continue;
      }
      const FieldDescriptor& value = *map_value(*step.field);
      if (value.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
        present = true;
        values.push_back(scalar(*element, value, 0));
        continue;
      }
      element = &element->GetReflection()->GetMessage(*element, &value);
    }

    if (last) {
      present = true;
    } else {
      collect(*element, at + 1, present, values);
    }
  }
}

void FieldPath::collect(const Message& message, std::size_t at, bool& present,
                        std::vector<Value>& values) const {
  const Step& step = steps_[at];
  const Reflection& reflection = *message.GetReflection();

  if (step.select == Select::kSize) {
    present = true;
    values.emplace_back(static_cast<double>(reflection.FieldSize(message, step.field)));
  } else if (step.select != Select::kField) {
    collect_elements(message, at, present, values);
  } else if (step.field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
    present = true;
    values.push_back(scalar(message, *step.field, 0));
  } else if (at + 1 == steps_.size()) {
    present = reflection.HasField(message, step.field);
  } else {
    collect(reflection.GetMessage(message, step.field), at + 1, present, values);
  }
}

std::vector<Value> FieldPath::values(const Message& message) const {
  bool present = false;
  std::vector<Value> values;
  collect(message, 0, present, values);
  return values;
}

bool FieldPath::present(const Message& message) const {
  bool present = false;
  std::vector<Value> values;
  collect(message, 0, present, values);
  return present;
}

Result<Condition> Condition::parse(const Descriptor& root, std::string_view path,
                                   const base::JsonValue& json) {
  auto compiled = FieldPath::compile(root, path);
  if (!compiled) return json.error(compiled.error().message);

  Condition condition;
  condition.path_ = *std::move(compiled);
  if (json.is_object() && json.has("present")) {
    TRY(json.expect_keys({"present"}));
    TRY_INIT(const auto present, json["present"].boolean());
    condition.present_ = present;
    return condition;
  }

  TRY_INIT(auto comparison, Comparison::parse(json, condition.path_.kind()));
  condition.comparison_ = std::move(comparison);
  return condition;
}

bool Condition::holds(const Message& message) const {
  if (present_) return path_.present(message) == *present_;
  const std::vector<Value> values = path_.values(message);
  return std::any_of(values.begin(), values.end(),
                     [this](const Value& value) { return comparison_.holds(value); });
}

std::string Condition::complaint(const Message& message) const {
  if (present_) {
    return fmt::format("{} is {}", path_.text(), *present_ ? "missing" : "present");
  }
  std::vector<std::string> values;
  for (const Value& value : path_.values(message)) values.push_back(to_text(value));
  return fmt::format("{} is {}, not {}", path_.text(),
                     values.empty() ? "missing" : fmt::format("{}", fmt::join(values, ", ")),
                     comparison_.text());
}

Result<std::vector<Condition>> parse_conditions(const Descriptor& root,
                                                const base::JsonValue& json) {
  if (!json.is_object()) return json.error("must be an object of fields and values");
  std::vector<Condition> conditions;
  for (const std::string& path : json.keys()) {
    TRY_INIT(auto condition, Condition::parse(root, path, json[path]));
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

}  // namespace cls::mock_server
