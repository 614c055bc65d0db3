// Resolving paths by reflection.
#include "mock-server/script/field_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "base/text/value_text.h"
#include "proto/field_access.h"

namespace cls::mock_server {
namespace {

using base::Error;
using base::Result;
using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

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
  return proto::with_access(field, [&](auto access) -> Value {
    auto value = access.get(message, field, index);
    if constexpr (std::is_same_v<decltype(value), bool> ||
                  std::is_same_v<decltype(value), std::string>) {
      return value;
    } else {
      if (field.cpp_type() != FieldDescriptor::CPPTYPE_ENUM) return static_cast<double>(value);
      const auto* named = field.enum_type()->FindValueByNumber(static_cast<int>(value));
      return named == nullptr ? fmt::format("{}", value) : named->name();
    }
  });
}

}  // namespace

const FieldDescriptor* find_field(const Descriptor& type, std::string_view name) {
  for (int i = 0; i < type.field_count(); ++i) {
    if (type.field(i)->name() == name || type.field(i)->json_name() == name) return type.field(i);
  }
  return nullptr;
}

std::string no_such_field(const Descriptor& type, std::string_view name) {
  std::vector<std::string_view> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return fmt::format("{} has no field '{}'{}", type.name(), name, base::did_you_mean(name, names));
}

Result<FieldPath::Step> FieldPath::compile_step(const Descriptor& type, std::string_view name,
                                                std::string_view selector) {
  Step step;
  step.field = find_field(type, name);
  if (step.field == nullptr) return Error{no_such_field(type, name)};
  if (!step.field->is_repeated()) return step;

  if (selector == "*") {
    step.select = Select::kAny;
  } else if (selector == "size") {
    step.select = Select::kSize;
  } else {
    step.select = step.field->is_map() ? Select::kKey : Select::kIndex;
    const std::optional<int> number = base::value_of<int>(selector);
    step.number = number.value_or(0);
    if (!number || (step.select == Select::kIndex && *number < 0)) {
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

    const FieldDescriptor& field =
        step.field->is_map() ? *step.field->message_type()->map_value() : *step.field;
    path.kind_ = step.select == Select::kSize ? ValueKind{} : kind_of(field);
    type = path.kind_.kind == ValueKind::Kind::kMessage ? field.message_type() : nullptr;
    if (step.select != Select::kField) ++i;
  }
  return path;
}

void FieldPath::collect_elements(const Message& message, std::size_t at, Found& found) const {
  const Step& step = steps_[at];
  const Reflection& reflection = *message.GetReflection();
  const auto add = [&found](Value value) {
    found.present = true;
    found.values.push_back(std::move(value));
  };

  for (int i = 0; i < reflection.FieldSize(message, step.field); ++i) {
    if (step.select == Select::kIndex && i != step.number) continue;
    if (step.field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
      add(scalar(message, *step.field, i));
      continue;
    }

    const Message* element = &reflection.GetRepeatedMessage(message, step.field, i);
    if (step.field->is_map()) {
      const FieldDescriptor& key = *step.field->message_type()->map_key();
      const Value wanted(static_cast<double>(step.number));
      if (step.select == Select::kKey && scalar(*element, key, 0) != wanted) continue;
      const FieldDescriptor& value = *step.field->message_type()->map_value();
      if (value.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
        add(scalar(*element, value, 0));
        continue;
      }
      element = &element->GetReflection()->GetMessage(*element, &value);
    }

    if (at + 1 == steps_.size()) {
      found.present = true;
    } else {
      collect(*element, at + 1, found);
    }
  }
}

void FieldPath::collect(const Message& message, std::size_t at, Found& found) const {
  const Step& step = steps_[at];
  const Reflection& reflection = *message.GetReflection();

  if (step.select == Select::kSize) {
    found.present = true;
    found.values.emplace_back(static_cast<double>(reflection.FieldSize(message, step.field)));
  } else if (step.select != Select::kField) {
    collect_elements(message, at, found);
  } else if (step.field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) {
    found.present = true;
    found.values.push_back(scalar(message, *step.field, 0));
  } else if (at + 1 == steps_.size()) {
    found.present = reflection.HasField(message, step.field);
  } else {
    collect(reflection.GetMessage(message, step.field), at + 1, found);
  }
}

FieldPath::Found FieldPath::find(const Message& message) const {
  Found found;
  collect(message, 0, found);
  return found;
}

Result<Condition> Condition::parse(const Descriptor& root, std::string_view path,
                                   const base::JsonValue& json) {
  auto compiled = FieldPath::compile(root, path);
  if (!compiled) return json.error(compiled.error().message);

  Condition condition;
  condition.path_ = *std::move(compiled);
  if (json.is_object() && json.has("present")) {
    TRY(json.expect_keys({"present"}));
    TRY_INIT(condition.present_, json["present"].boolean());
  } else {
    TRY_INIT(condition.comparison_, Comparison::parse(json, condition.path_.kind()));
  }
  return condition;
}

bool Condition::holds(const Message& message) const {
  if (present_) return path_.present(message) == *present_;
  const std::vector<Value> values = path_.values(message);
  return std::ranges::any_of(values,
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
